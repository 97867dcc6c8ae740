#pragma once

#include <string>

#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

struct DialogSpec {
  std::string id;
  const char* icon = "";
  std::string title = {};
  float width = 480.0F; ///< Design pixels.
  float across = 0.5F;  ///< Middle of the dialog as a part of the window's width.
  float height = 0.0F; ///< Design pixels; 0: as high as the content, which scrolls where the window is lower.
  bool closable = true; ///< Esc and the cross close it.
  bool darkens = true;  ///< What is behind it; not where the dialog is about what is seen there.
};

/// A dialog in the middle of the window that takes all input while it is open. True when its content is to be
/// drawn, and endDialog called; `open` becomes false when the user closes it. It never gets larger than the
/// window, and shows no tooltip before the mouse has moved.
[[nodiscard]] bool beginDialog(PanelContext& context, const DialogSpec& spec, bool& open);
void endDialog();

/// Whether a key went down in this frame (or repeats).
[[nodiscard]] bool keyPressed(int imguiKey, bool repeat = false);
/// Whether Enter went down in this frame, that of the keypad or the other one.
[[nodiscard]] bool enterPressed();

/// Moves a highlighted row with the arrow keys; stays in [0, count).
void moveHighlight(int& highlighted, int count);

/// Ends the dialog's content: buttons at the right end of its last row, which never scrolls. The index that
/// was clicked, or -1; the last one is the primary one.
int dialogButtons(PanelContext& context, const std::string& id, const std::vector<ButtonSpec>& buttons);

// Each draws its dialog while the state says that it is open.
void drawFileDialog(PanelContext& context);
void drawCommandPalette(PanelContext& context);
void drawKeysOverview(PanelContext& context);
void drawSettingsDialog(PanelContext& context);
void drawQuestions(PanelContext& context); ///< Unsaved changes, first start, restored work, about.
void drawJointDialog(PanelContext& context);
void drawRenameDialog(PanelContext& context);
void drawClipDialog(PanelContext& context);
void drawClipStyleDialog(PanelContext& context);
void drawPoseLibraryDialog(PanelContext& context);
void drawReferenceDialog(PanelContext& context);
void drawHistoryDialog(PanelContext& context);

} // namespace stretch::ui

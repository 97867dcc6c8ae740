#pragma once

#include <string>

#include "ui/panels/panel_support.h"

namespace stretch::ui {

struct DialogSpec {
  std::string id;
  const char* icon = "";
  std::string title = {};
  float width = 480.0F; ///< Design pixels.
  float height = 0.0F;  ///< Design pixels; 0: as high as the content.
  bool closable = true; ///< Esc and the cross close it.
};

/// A dialog in the middle of the window that takes all input while it is open. True when its content is to be
/// drawn, and endDialog called; `open` becomes false when the user closes it.
[[nodiscard]] bool beginDialog(PanelContext& context, const DialogSpec& spec, bool& open);
void endDialog();

/// Whether a key went down in this frame (or repeats).
[[nodiscard]] bool keyPressed(int imguiKey, bool repeat = false);

/// Moves a highlighted row with the arrow keys; stays in [0, count).
void moveHighlight(int& highlighted, int count);

/// Buttons at the right end of the dialog's last row. The index that was clicked, or -1; the last one is the
/// primary one.
int dialogButtons(PanelContext& context, const std::string& id, const std::vector<ButtonSpec>& buttons);

// Each draws its dialog while the state says that it is open.
void drawFileDialog(PanelContext& context);
void drawCommandPalette(PanelContext& context);
void drawKeysOverview(PanelContext& context);
void drawSettingsDialog(PanelContext& context);
void drawQuestions(PanelContext& context); ///< Unsaved changes, first start, restored work, about.
void drawJointDialog(PanelContext& context);
void drawRenameDialog(PanelContext& context);
void drawHistoryDialog(PanelContext& context);

} // namespace stretch::ui

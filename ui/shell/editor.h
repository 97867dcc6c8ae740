#pragma once

#include <filesystem>
#include <vector>

#include "ui/shell/shell.h"
#include "ui/shell/window/window.h"

namespace stretch::ui {

struct DrivenMouse;

/// Stands in for the user's hand: feeds input before a frame and looks at what was drawn after it.
class EditorHand {
public:
  virtual ~EditorHand() = default;

  /// Before a frame: may feed the window's input queue. False: the editor is to end.
  virtual bool beforeFrame(Shell& shell, Window& window) = 0;
  /// Whether the frame that was begun is painted: what nobody looks at takes most of a processor's time where
  /// there is no graphics card.
  [[nodiscard]] virtual bool paints() const = 0;
  /// After a frame was drawn and before it is shown.
  virtual void afterFrame(Shell& shell, const WindowSize& size) = 0;
  /// Replaces the window's mouse.
  [[nodiscard]] virtual const DrivenMouse& mouse() const = 0;
  /// The editor is to end as a crash would: nothing is closed or written.
  [[nodiscard]] virtual bool abandons() const = 0;
};

struct EditorOptions {
  float scale = 0.0F; ///< The screen's scale, in place of what the screen says; 0: that.
  int width = 0;      ///< Width of the window; 0: as it was left.
  int height = 0;
  EditorHand* hand = nullptr; ///< Null: a user's.
  bool firstStart = false;    ///< The hand is shown the tour, as a user is at the first start.
};

/// Opens the editor, on a file or mesh sequence unless there is none, and returns when the user leaves: 0, or
/// 1 with one line on standard error when there is no display or no OpenGL 3.3.
int runEditor(const std::vector<std::filesystem::path>& files, const EditorOptions& options = {});

} // namespace stretch::ui

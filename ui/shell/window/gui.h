#pragma once

#include "core/base/result.h"
#include "ui/shell/window/window.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

/// Place of the mouse and what it holds, when something else moves it than a hand.
struct DrivenMouse {
  float x = 0.0F; ///< Window units.
  float y = 0.0F;
  bool buttons[3] = {false, false, false}; ///< Left, right, middle.
  float wheel = 0.0F;
};

/// Dear ImGui with its backends for one window.
class Gui {
public:
  [[nodiscard]] static Result<Gui> create(Window& window);
  Gui(Gui&&) noexcept;
  Gui& operator=(Gui&&) = delete;
  ~Gui();

  /// Loads fonts and style anew.
  [[nodiscard]] Theme setTheme(ThemeKind kind, float scale);

  /// `input`: of the window, whose mouse buttons are played. `mouse` replaces them, and time then runs in
  /// steps of a sixtieth of a second; null for a user.
  void beginFrame(InputQueue& input, const DrivenMouse* mouse);
  /// Ends the frame: the widgets stand.
  void endFrame();
  /// Draws the widgets of the frame that was ended into the window.
  void paint(const Theme& theme, const WindowSize& size);

private:
  Gui() = default;
  bool alive_ = false;
};

} // namespace stretch::ui

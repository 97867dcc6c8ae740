#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "ui/shell/window/input.h"

namespace stretch::ui {

struct WindowOptions {
  std::string title = "Stretch-Engine";
  int width = 1280; ///< Window units, made to fit the screen.
  int height = 720;
  bool maximised = false;
  bool visible = true;
};

struct WindowSize {
  int width = 0; ///< Window units, which the mouse is told in.
  int height = 0;
  int framebufferWidth = 0; ///< Pixels.
  int framebufferHeight = 0;
};

/// The program's window, with an OpenGL 3.3 core context that is current on this thread.
class Window {
public:
  /// An error when there is no display, or no such OpenGL.
  [[nodiscard]] static Result<Window> open(const WindowOptions& options);
  Window(Window&&) noexcept;
  Window& operator=(Window&&) noexcept;
  ~Window();

  [[nodiscard]] GLFWwindow* handle() const { return handle_; }
  [[nodiscard]] InputQueue& input() { return *input_; }
  [[nodiscard]] WindowSize size() const;
  /// Window units a design pixel, as the screen wants it.
  [[nodiscard]] float contentScale() const;
  void setTitle(const std::string& title);
  /// Shows what was drawn.
  void present();

private:
  Window() = default;
  GLFWwindow* handle_ = nullptr;
  std::unique_ptr<InputQueue> input_;
  std::string title_;
};

/// Waits for something to happen, at most this long; 0 only takes what is there.
void waitForEvents(double secondsAtMost);

/// Seconds of a clock that only runs forward.
[[nodiscard]] double clockSeconds();

} // namespace stretch::ui

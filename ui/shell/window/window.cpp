#include "ui/shell/window/window.h"

#include <algorithm>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace stretch::ui {

namespace {

/// GLFW's own words for what failed last.
std::string lastProblem() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description == nullptr ? std::string("unknown reason") : std::string(description);
}

Error noWindow(const std::string& reason) {
  return Error{"cannot open a window: " + reason, "display",
               "start it on a desktop with OpenGL 3.3, or use the verbs that need no window (--help)"};
}

void setHints(const WindowOptions& options) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0); // The viewport draws into targets of its own.
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_MAXIMIZED, options.maximised ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "stretch-engine");
}

/// Makes a window that is larger than the free part of its screen as small as that.
void fitOnScreen(GLFWwindow* window) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) {
    return;
  }
  int left = 0, top = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &left, &top, &width, &height);
  int frameLeft = 0, frameTop = 0, frameRight = 0, frameBottom = 0;
  glfwGetWindowFrameSize(window, &frameLeft, &frameTop, &frameRight, &frameBottom);
  width -= frameLeft + frameRight;
  height -= frameTop + frameBottom;
  int wantedWidth = 0, wantedHeight = 0;
  glfwGetWindowSize(window, &wantedWidth, &wantedHeight);
  if (width <= 0 || height <= 0 || (wantedWidth <= width && wantedHeight <= height)) {
    return;
  }
  glfwSetWindowSize(window, std::min(wantedWidth, width), std::min(wantedHeight, height));
  glfwSetWindowPos(window, left + frameLeft, top + frameTop);
}

} // namespace

Result<Window> Window::open(const WindowOptions& options) {
  if (glfwInit() != GLFW_TRUE) {
    return noWindow(lastProblem());
  }
  setHints(options);
  Window window;
  window.input_ = std::make_unique<InputQueue>();
  window.title_ = options.title;
  window.handle_ = glfwCreateWindow(std::max(options.width, 320), std::max(options.height, 240),
                                    options.title.c_str(), nullptr, nullptr);
  if (window.handle_ == nullptr) {
    const Error error = noWindow(lastProblem());
    glfwTerminate();
    return error;
  }
  if (!options.maximised) {
    fitOnScreen(window.handle_);
  }
  glfwMakeContextCurrent(window.handle_);
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(window.handle_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return window;
}

Window::Window(Window&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)), input_(std::move(other.input_)),
      title_(std::move(other.title_)) {}

Window& Window::operator=(Window&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(input_, other.input_);
  std::swap(title_, other.title_);
  return *this;
}

Window::~Window() {
  if (handle_ != nullptr) {
    glfwDestroyWindow(handle_);
    glfwTerminate();
  }
}

WindowSize Window::size() const {
  WindowSize size;
  glfwGetWindowSize(handle_, &size.width, &size.height);
  glfwGetFramebufferSize(handle_, &size.framebufferWidth, &size.framebufferHeight);
  return size;
}

float Window::contentScale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(handle_, &x, &y);
  const WindowSize now = size();
  // Where window units are not pixels the screen's scale is in the framebuffer already.
  const float perUnit =
      now.width > 0 ? static_cast<float>(now.framebufferWidth) / static_cast<float>(now.width) : 1.0F;
  return std::clamp(std::max(x, y) / std::max(perUnit, 0.1F), 0.5F, 8.0F);
}

void Window::setTitle(const std::string& title) {
  if (title != title_) {
    title_ = title;
    glfwSetWindowTitle(handle_, title.c_str());
  }
}

void Window::present() {
  glfwSwapBuffers(handle_);
}

void waitForEvents(double secondsAtMost) {
  if (secondsAtMost > 0.0) {
    glfwWaitEventsTimeout(secondsAtMost);
  } else {
    glfwPollEvents();
  }
}

double clockSeconds() {
  return glfwGetTime();
}

} // namespace stretch::ui

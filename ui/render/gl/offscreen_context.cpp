#include "ui/render/gl/offscreen_context.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include <dlfcn.h>
#include <epoxy/egl.h>

namespace stretch::ui {

struct OffscreenContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (display == EGL_NO_DISPLAY) {
      return;
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) {
      eglDestroyContext(display, context);
    }
    eglTerminate(display);
  }
};

namespace {

Error lacking(const char* what) {
  return {what, "pictures without a display",
          "install Mesa's software driver (package libgl1-mesa-dri) and libegl1"};
}

bool isThereAny(std::initializer_list<const char*> libraries) {
  return std::ranges::any_of(libraries, [](const char* name) { return dlopen(name, RTLD_LAZY) != nullptr; });
}

EGLDisplay surfacelessDisplay() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  }
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext coreContext(EGLDisplay display) {
  constexpr std::array<EGLint, 3> wantedConfig{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, wantedConfig.data(), &config, 1, &count) != EGL_TRUE || count == 0) {
    config = nullptr; // surfaceless contexts need none
  }
  constexpr std::array<EGLint, 7> wantedContext{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, wantedContext.data());
}

} // namespace

OffscreenContext::OffscreenContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;
OffscreenContext::~OffscreenContext() = default;

Result<OffscreenContext> OffscreenContext::create() {
  // epoxy ends the program where it finds none of them.
  if (!isThereAny({"libEGL.so.1"}) || !isThereAny({"libOpenGL.so.0", "libGL.so.1"})) {
    return lacking("no library of EGL or OpenGL is there");
  }
  auto handles = std::make_unique<Handles>();
  const EGLDisplay display = surfacelessDisplay();
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    return lacking("EGL gives no display to draw with");
  }
  handles->display = display;
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    return lacking("EGL has no desktop OpenGL");
  }
  handles->context = coreContext(display);
  if (handles->context == EGL_NO_CONTEXT) {
    return lacking("the driver has no OpenGL 3.3 core context");
  }
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles->context) != EGL_TRUE) {
    return lacking("the driver cannot draw without a surface");
  }
  return OffscreenContext(std::move(handles));
}

} // namespace stretch::ui

#pragma once

#include <memory>

#include "core/base/result.h"

namespace stretch::ui {

/// An OpenGL 3.3 core context without a window or display (EGL, surfaceless), current on the calling thread
/// while it lives.
class OffscreenContext {
public:
  /// An error says what the system lacks.
  [[nodiscard]] static Result<OffscreenContext> create();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;
  ~OffscreenContext();

private:
  struct Handles;
  explicit OffscreenContext(std::unique_ptr<Handles> handles);
  std::unique_ptr<Handles> handles_;
};

} // namespace stretch::ui

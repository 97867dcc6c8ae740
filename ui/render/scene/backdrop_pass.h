#pragma once

#include <functional>
#include <memory>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "ui/render/gl/gl_objects.h"
#include "ui/render/gl/shader_program.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// Gives an image when it is drawn; null for none, an error where it cannot be read.
using BackdropImage = std::function<Result<std::shared_ptr<const Image>>()>;

/// An image between the background and all that stands in the view.
struct Backdrop {
  BackdropImage image = {};
  double across = 0.5; ///< 0: at the left end of the view, 1: at the right one.
  double height = 1.0; ///< Share of the view's height.
  double opacity = 1.0;
};

/// Left, bottom, right and top of an image in the view, of whose width and height these are shares.
[[nodiscard]] Vec4 backdropBox(const Backdrop& backdrop, const Image& image, const Viewport& viewport);

/// Draws backdrops; an image goes to the graphics card once, for as long as it is the one that is drawn.
class BackdropPass {
public:
  [[nodiscard]] static Result<BackdropPass> create();

  /// Over what is drawn in the bound framebuffer; no depth is written. What cannot be read is not drawn.
  void draw(const Viewport& viewport, const Backdrop& backdrop);

private:
  ShaderProgram program_;
  GlVertexArray nothing_;
  std::shared_ptr<const Image> uploaded_;
  GlTexture texture_;
};

} // namespace stretch::ui

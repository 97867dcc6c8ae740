#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "ui/render/gl/gl_objects.h"

namespace stretch::ui {

/// A picture in the graphics card's memory, drawn with anti-aliasing and resolved to an RGBA8 texture whose
/// bytes are sRGB already: a widget that shows textures as they are shows it right. Rows run from the bottom
/// (OpenGL's way).
class RenderTarget {
public:
  /// Makes the target that large, in pixels, if it is not yet. Sizes are clamped to 1 and the driver's limit,
  /// samples to what the driver has. An error when the driver cannot give the memory.
  Status resize(int widthPixels, int heightPixels, int samples);

  /// Draw here; the viewport covers the target.
  void bind() const;
  /// Resolves what was drawn: the texture is up to date afterwards.
  void resolve() const;

  [[nodiscard]] unsigned textureId() const { return texture_.name(); }
  /// Name of the framebuffer that `bind` binds.
  [[nodiscard]] unsigned framebufferId() const { return drawn_.name(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// The resolved pixels, rows from the top.
  [[nodiscard]] Image readPixels() const;

private:
  int width_ = 0;
  int height_ = 0;
  int samples_ = 0;
  GlTexture texture_;
  GlFramebuffer resolved_;
  GlRenderbuffer color_;
  GlRenderbuffer depth_;
  GlFramebuffer drawn_;
};

/// A texture that passes draw into, without depth: for shadows and blurs.
struct TextureTarget {
  GlTexture texture;
  GlFramebuffer framebuffer;
  int side = 0;
};

/// Square, two 8-bit channels, linear filter, clamped.
[[nodiscard]] TextureTarget makeMaskTarget(int side);
/// Square depth texture with comparison, for a shadow map.
[[nodiscard]] TextureTarget makeDepthTarget(int side);

} // namespace stretch::ui

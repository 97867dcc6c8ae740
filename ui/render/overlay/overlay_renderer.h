#pragma once

#include "core/base/result.h"
#include "ui/render/gl/shader_program.h"
#include "ui/render/overlay/overlay.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

/// Draws overlays into the framebuffer that is bound, over a scene whose depth it holds. All sizes grow with
/// Viewport::pixelsPerPoint. Positions are made relative to the eye before they lose precision.
class OverlayRenderer {
public:
  [[nodiscard]] static Result<OverlayRenderer> create();
  void draw(const View& view, const Overlay& overlay, const Palette& palette) const;

private:
  void drawLines(const View& view, const Overlay& overlay, const Palette& palette) const;
  void drawMarkers(const View& view, const Overlay& overlay) const;
  void drawArrows(const View& view, const Overlay& overlay) const;

  ShaderProgram line_;
  ShaderProgram marker_;
  ShaderProgram solid_;
  GlBuffer instances_;
  GlVertexArray lineArray_;
  GlVertexArray markerArray_;
  GlVertexArray solidArray_;
};

} // namespace stretch::ui

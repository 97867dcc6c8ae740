#pragma once

#include "ui/render/scene/shadow_pass.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

struct FloorPlace {
  double height = 0.0; ///< World y.
  double characterHeight = 1.0;
  Vec2 centre{0.0};   ///< World x, z around which the floor fades.
  bool covers = true; ///< It hides what lies behind it; else its lines and shadows alone are drawn.
};

/// The ground of the picture: a quiet gradient, and a floor with a grid that fades out.
class FloorPass {
public:
  [[nodiscard]] static Result<FloorPass> create();

  /// Fills the bound framebuffer and clears its depth.
  void drawBackground(const Palette& palette) const;
  /// Blends the floor over what is drawn, behind whatever stands in front of it.
  void drawFloor(const View& view, const Palette& palette, const FloorPlace& place,
                 const ShadowMaps& shadows) const;

private:
  ShaderProgram background_;
  ShaderProgram floor_;
  GlVertexArray nothing_;
};

} // namespace stretch::ui

#pragma once

#include "ui/render/gl/render_target.h"
#include "ui/render/gl/shader_program.h"
#include "ui/render/scene/lighting.h"
#include "ui/render/scene/scene_upload.h"
#include "ui/render/view/quality.h"

namespace stretch::ui {

/// Shadows of one frame. Texture names are 0 where the quality leaves a shadow out.
struct ShadowMaps {
  unsigned floorTexture = 0; ///< (contact, key shadow) on the floor's area.
  FloorArea area;
  unsigned depthTexture = 0;   ///< From the key light.
  Mat4 worldToDepth{1.0};      ///< World to the depth texture, 0..1.
  double depthTexelSize = 0.0; ///< World units.
};

struct ShadowScene {
  Box box; ///< Box of the posed character.
  double floorHeight = 0.0;
  double characterHeight = 1.0;
  Vec3 towardsKey{0.0, 1.0, 0.0};
};

/// Draws the shadows of posed items: on the floor (flattened, blurred) and, for the character itself, a
/// shadow map.
class ShadowPass {
public:
  [[nodiscard]] static Result<ShadowPass> create();
  [[nodiscard]] ShadowMaps draw(const UploadedScene& uploaded, const ShadowScene& scene,
                                const Quality& quality);

private:
  void drawFloorShadow(const UploadedScene& uploaded, const ShadowScene& scene, const FloorArea& area,
                       int blurs);
  void blur(int times);
  void drawDepth(const UploadedScene& uploaded, const Mat4& projection);

  ShaderProgram flatten_;
  ShaderProgram blurProgram_;
  ShaderProgram depth_;
  GlVertexArray nothing_;
  TextureTarget floor_;
  TextureTarget floorSpare_;
  TextureTarget depthTarget_;
};

} // namespace stretch::ui

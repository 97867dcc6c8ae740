#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/anim/frame_state.h"
#include "ui/render/gl/render_target.h"
#include "ui/render/gl/shader_program.h"
#include "ui/render/scene/scene_upload.h"

namespace stretch::ui {

/// Attributes that a joint adds to the look of the surface that follows it; blended by the skin's weights.
struct JointAttributes {
  std::vector<double> stretchRatio; ///< One for each node; empty counts as 1.
  std::vector<float> highlight;     ///< One for each node, 0..1; empty counts as 0.
};

/// Poses every item of an uploaded scene on the graphics card: once a frame, for all passes that draw it.
class PosingPass {
public:
  [[nodiscard]] static Result<PosingPass> create();

  /// `turning`: the frame whose joints' own matrices turn normals (skinning::NormalMatrix::plain); null: they
  /// stay upright on the surface.
  void pose(const Scene& scene, UploadedScene& uploaded, const FrameState& frame,
            const JointAttributes& attributes, const FrameState* turning = nullptr) const;

private:
  explicit PosingPass(ShaderProgram program);

  ShaderProgram program_;
  GlBuffer matrices_;
  GlTexture matrixTexture_;
  TextureTarget unseen_; ///< Drivers without a window refuse to draw, even unseen, when no framebuffer is
                         ///< bound.
};

/// Posed world positions of an item as the graphics card computed them, read back; for comparing with the
/// CPU.
[[nodiscard]] std::vector<glm::vec3> readPosedPositions(const UploadedScene& uploaded, std::size_t item);
[[nodiscard]] std::vector<glm::vec3> readPosedNormals(const UploadedScene& uploaded, std::size_t item);

} // namespace stretch::ui

#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/base/result.h"
#include "skinning/linear_blend_skinning.h"
#include "ui/render/scene/backdrop_pass.h"
#include "ui/render/scene/bounds.h"
#include "ui/render/scene/scene_shape.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/palette.h"
#include "ui/render/view/quality.h"

namespace stretch::ui {

/// Source of the surface's colours.
enum class SurfaceShading {
  material,     ///< The file's materials.
  stretchHeat,  ///< How much each joint's mesh is stretched, blended by the weights.
  jointWeights, ///< The weights of the highlighted joints.
  clay,         ///< One calm grey.
};

/// The character at another time, drawn flat and translucent.
struct Ghost {
  FrameState frame;
  glm::vec4 tint{1.0F}; ///< sRGB and opacity.
};

/// How the scene is shown.
struct SceneStyle {
  Palette palette = darkPalette();
  Quality quality;
  SurfaceShading shading = SurfaceShading::material;
  skinning::NormalMatrix normals = skinning::NormalMatrix::inverseTranspose;
  bool newStretchTurns = true; ///< What is stretched here turns normals, where these are plain: false where
                               ///< the file will tell it by translations.
  bool mesh = true;
  bool floor = true;
  bool wireframe = false;
  SceneMeasures measures;
  std::vector<float> highlight;     ///< One for each node, 0..1: how much the joint belongs to the selection;
                                    ///< empty for none.
  std::vector<double> stretchRatio; ///< One for each node for the heat-map; empty: what FrameState::stretch
                                    ///< says.
  std::optional<Backdrop> backdrop = {};
};

/// Draws a scene at a moment into the framebuffer that is bound, which has a depth buffer. A context of
/// OpenGL 3.3 core must be current, always the same one, also when the renderer goes.
class SceneRenderer {
public:
  [[nodiscard]] static Result<SceneRenderer> create();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;
  ~SceneRenderer();

  /// Uploads the scene; replaces the one before. The scene must outlive the renderer's use of it.
  void setScene(const Scene& scene);
  /// Estimated seconds that a picture of the whole scene takes where it is heavy and drawn in software:
  /// Quality::thinned draws it with few triangles (thinnedMeshes) instead. 0 where it is not, and once the
  /// scene was reshaped.
  [[nodiscard]] double secondsUnthinned() const;

  /// Moves the vertices of the scene; everything else stays on the graphics card as it is.
  void reshape(const SceneShape& shape);

  /// Background and backdrop, floor with shadows, ghosts, character. `targetFramebuffer` is the framebuffer
  /// to draw into.
  void draw(const View& view, const FrameState& frame, std::span<const Ghost> ghosts, const SceneStyle& style,
            unsigned targetFramebuffer);

  /// World positions that the graphics card poses for the k-th drawn primitive, in the order of nodes and
  /// primitives.
  [[nodiscard]] std::vector<glm::vec3> posedPositions(const FrameState& frame, std::size_t primitive);
  [[nodiscard]] std::vector<glm::vec3> posedNormals(const FrameState& frame, std::size_t primitive,
                                                    const SceneStyle& style = {});

private:
  struct Parts;
  explicit SceneRenderer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

} // namespace stretch::ui

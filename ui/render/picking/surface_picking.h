#pragma once

#include <optional>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// The surface of a character in one pose, to be picked from.
struct PosedSurface {
  std::vector<NodeIndex> nodes; ///< That draw a mesh.
  std::vector<Vec3> positions;  ///< World, of every vertex of theirs, in the order of their primitives.
};

[[nodiscard]] PosedSurface posedSurface(const Scene& scene, const FrameState& frame);

/// How much each joint carries of the place that was hit; a rigid mesh is carried by its node alone.
struct SurfaceShare {
  NodeIndex node;
  double weight = 0.0;
};
struct SurfaceHit {
  std::vector<SurfaceShare> shares; ///< At least one.
  double depth = 0.0;               ///< Depth of the hit, -1..1: the nearest.
};

/// Finds what lies under the mouse, in front of everything else; nothing beside the character. What reaches
/// behind the eye is not hit.
[[nodiscard]] std::optional<SurfaceHit> pickSurface(const View& view, const Scene& scene,
                                                    const PosedSurface& surface, const Vec2& mousePixels);

} // namespace stretch::ui

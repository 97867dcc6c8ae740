#pragma once

#include <optional>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/math/types.h"
#include "core/scene/scene.h"

namespace stretch::rig {

/// The outermost points of the mesh that follows each node, to tell how low a part of the body is without
/// looking at all of its mesh.
struct BodyOutline {
  std::vector<std::vector<Vec3>> points; ///< One list for each node, in its space; empty: nothing follows it.
  std::vector<NodeIndex> body;           ///< The character's nodes that have points.
  std::vector<NodeIndex> riding;         ///< Those of them that hang on the hips and on no limb with weight.
};

/// The points of every node: those of its mesh that are farthest out in some fifty directions, in the bind
/// pose. `body` and `riding` stay empty.
[[nodiscard]] BodyOutline outlineOf(const Scene& scene);

/// Returns those of `nodes` that have points.
[[nodiscard]] std::vector<NodeIndex> outlined(const BodyOutline& outline,
                                              const std::vector<NodeIndex>& nodes);

/// Height along +Y of the lowest point of `nodes` in a frame, their stretch included; nothing where none has
/// points.
[[nodiscard]] std::optional<double> lowestOf(const BodyOutline& outline, const std::vector<NodeIndex>& nodes,
                                             const FrameState& frame);

} // namespace stretch::rig

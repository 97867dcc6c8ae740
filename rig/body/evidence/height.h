#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig::body {

/// How far a character reaches by its vertices, by its joints where it has no vertices; world units, > 0; 1
/// where nothing has an extent.
struct CharacterExtent {
  double height = 1.0;  ///< Extent of the shown body along +Y.
  double stature = 1.0; ///< Height in its bind pose, along +Y.
  double largest = 1.0; ///< In its bind pose, along whichever axis it is largest.
};

/// Parts of a character that tell what of it is its body, and how it stands.
struct BodyParts {
  NodeIndex hips;               ///< -1: unknown.
  std::vector<NodeIndex> hands; ///< Nodes that hold what hangs on them rigidly.
  Vec3 up{0.0};                 ///< In the bind pose; zero: unknown.
};

/// Height in a frame, and of the bind pose the extents in the frame's units. Skinned meshes count where there
/// are any, and with them the rigid ones at or below the hips that no hand holds; else the rigid ones of the
/// hips' whole tree. The stature of a body whose `up` is more than 35 degrees from the Y axis is its largest
/// extent. A body that lies or is folded up in the frame shows little of its height: half of its stature
/// counts at least.
[[nodiscard]] CharacterExtent characterExtent(const Scene& scene, const BindPose& bindPose,
                                              const BodyParts& parts, const FrameState& shown);

} // namespace stretch::rig::body

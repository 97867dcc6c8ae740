#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace stretch::rig {

/// World matrices of all nodes in the bind pose: what the inverse bind matrices say, placed in the world as
/// the topmost joint of each skin stands at rest; nodes that no skin binds follow their parents by their rest
/// transforms.
[[nodiscard]] std::vector<Mat4> bindPoseWorlds(const Scene& scene);

namespace body {

struct BindPose {
  std::vector<Mat4> worlds;     ///< World matrix of every node in the bind pose.
  std::vector<Mat4> placements; ///< One for each skin: its bind-pose model space to world.
  std::vector<bool> areAtRest;  ///< One for each skin: its matrices tell no bind pose.
};

/// The bind pose of every skin, placed in the world. The largest skin stands where its topmost joint stands
/// at rest; a skin that shares a joint with one placed before stands where that joint is; any other one hangs
/// at rest from the nearest node above it. Bones that come out more than twice or less than half as long as
/// at rest are in other units than the scene, and the skin is scaled to the scene's. Matrices that cannot be
/// a bind pose (singular, not finite, or the identity under a parent whose matrix is not, or above joints
/// that it alone puts in other units, as exporters write for joints that move nothing) are replaced by the
/// rest transform; so are those of a skin that are all alike while its joints rest apart, as without any.
[[nodiscard]] BindPose placeBindPose(const Scene& scene);

} // namespace body

} // namespace stretch::rig

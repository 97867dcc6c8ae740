#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// What hangs on one bone of a limb: the nodes that its stretch concerns (docs/rig.md, What belongs
/// to a bone).
struct BoneTopology {
  /// The joint that carries the bone.
  int joint = -1;
  /// From the joint's child down to the next limb joint or the end, both included; empty where the end is
  /// estimated or not a descendant.
  std::vector<int> pathNodes;
  /// Joints that lie along the bone and deform with it; parents first. May contain path nodes.
  std::vector<int> twistNodes;
  /// Children of the joint that are not on the path: moved by the bone's stretch.
  std::vector<int> hanging;
};

/// The nodes of a limb, by bone.
struct LimbTopology {
  /// One for each joint of the limb, base first.
  std::vector<BoneTopology> bones;
  /// Children of the base joint that start another limb on the body's side (thighs under a joint that also
  /// starts the spine): they stay where they are.
  std::vector<int> staying;
  /// Of the last joint; false for a foot under the root. True when the end is estimated.
  bool endIsDescendant = true;
};

/// `others`: all limbs of the character, so that a limb hanging on a bone is not taken for a twist joint.
/// `bindWorlds`: world matrices of the bind pose (bindPoseWorlds).
[[nodiscard]] LimbTopology limbTopology(const Scene& scene, const Limb& limb, const std::vector<Limb>& others,
                                        const std::vector<Mat4>& bindWorlds);

/// Every node whose local transform a trail on this limb may change, ascending, without repeats.
[[nodiscard]] std::vector<int> touchedNodes(const Limb& limb, const LimbTopology& topology);

/// Position of the limb's end in world space.
[[nodiscard]] Vec3 endPosition(const Limb& limb, const std::vector<Mat4>& worlds);

/// Positions of the limb's joints, base first, and of its end: one more than Limb::joints.
[[nodiscard]] std::vector<Vec3> limbPoints(const Limb& limb, const std::vector<Mat4>& worlds);

/// The same in a frame whose limbs may be stretched: an estimated end moves with the stretch of the bone that
/// it ends.
[[nodiscard]] Vec3 endPosition(const Limb& limb, const FrameState& frame);
[[nodiscard]] std::vector<Vec3> limbPoints(const Limb& limb, const FrameState& frame);

/// Straight distance from the limb's base to its end in a frame.
[[nodiscard]] double limbLength(const Limb& limb, const FrameState& frame);

} // namespace stretch::rig

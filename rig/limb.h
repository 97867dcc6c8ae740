#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/math/types.h"
#include "core/scene/node_index.h"

namespace stretch::rig {

enum class LimbKind { leftArm, rightArm, leftLeg, rightLeg, spine, neck, chain };

/// "left-arm" ... "neck"; "chain" for any other chain.
[[nodiscard]] std::string_view limbName(LimbKind kind);

[[nodiscard]] constexpr bool isLeg(LimbKind kind) {
  return kind == LimbKind::leftLeg || kind == LimbKind::rightLeg;
}

/// A chain of joints that is stretched as one.
struct Limb {
  LimbKind kind = LimbKind::chain;
  std::string id;                ///< "left-arm", or "JOINT_A..JOINT_B" as the user wrote it.
  std::vector<NodeIndex> joints; ///< Nodes from the base to the last joint before the end, base first; at
                                 ///< least one. Twist joints and helper nodes between them are not listed:
                                 ///< they ride on their bone.
  NodeIndex endNode;       ///< The end joint (wrist, ankle, ...); need not be a descendant of `joints`. -1:
                           ///< estimated.
  Vec3 endOffset{0.0};     ///< Where the end is when endNode is -1: in the space of joints.back().
  double restLength = 0.0; ///< Sum of the bone lengths in the bind pose, world units.
  double confidence = 1.0; ///< 0..1.
  std::vector<std::string> reasons; ///< Why these joints: for the user.

  friend bool operator==(const Limb&, const Limb&) = default;
};

[[nodiscard]] inline bool isLeg(const Limb& limb) {
  return isLeg(limb.kind);
}

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

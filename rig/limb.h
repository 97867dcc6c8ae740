#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/math/types.h"
#include "core/scene/node_index.h"

namespace stretch::rig {

/// In the order in which the limbs of a body are listed.
enum class LimbKind { arm, leg, spine, neck, tail, wing, fin, feeler, chain };
enum class LimbSide { left, right, middle };

/// Role of a limb in its body. Limbs are listed by kind, then from front to back, the left one first.
struct LimbPlace {
  LimbKind kind = LimbKind::chain;
  LimbSide side = LimbSide::middle;
  int row = 0; ///< From front to back, 1 is the first; 0 where the body has one row of the kind.

  friend bool operator==(const LimbPlace&, const LimbPlace&) = default;
  friend constexpr auto operator<=>(const LimbPlace& a, const LimbPlace& b) {
    return std::tuple(a.kind, a.row, a.side) <=> std::tuple(b.kind, b.row, b.side);
  }
};

/// The places of a biped's limbs.
namespace biped {
inline constexpr LimbPlace leftArm{LimbKind::arm, LimbSide::left};
inline constexpr LimbPlace rightArm{LimbKind::arm, LimbSide::right};
inline constexpr LimbPlace leftLeg{LimbKind::leg, LimbSide::left};
inline constexpr LimbPlace rightLeg{LimbKind::leg, LimbSide::right};
inline constexpr LimbPlace spine{LimbKind::spine};
inline constexpr LimbPlace neck{LimbKind::neck};
} // namespace biped

/// "arm", "leg" ... "chain", and the kind of such a word; nothing for any other.
[[nodiscard]] std::string_view kindName(LimbKind kind);
[[nodiscard]] std::optional<LimbKind> kindNamed(std::string_view name);

/// "left-arm" ... "neck", without the row; "chain" for a chain that is nothing else.
[[nodiscard]] std::string limbName(const LimbPlace& limb);

[[nodiscard]] constexpr bool isLeg(const LimbPlace& limb) {
  return limb.kind == LimbKind::leg;
}
[[nodiscard]] constexpr bool isArm(const LimbPlace& limb) {
  return limb.kind == LimbKind::arm;
}
/// Whether a limb is part of the body's middle, which carries the other limbs.
[[nodiscard]] constexpr bool isTrunk(const LimbPlace& limb) {
  return limb.kind == LimbKind::spine || limb.kind == LimbKind::neck;
}
/// Whether it has a hand or a foot, which can be kept at a place.
[[nodiscard]] constexpr bool hasHandOrFoot(const LimbPlace& limb) {
  return isArm(limb) || isLeg(limb);
}
/// Whether it reaches out from the trunk: its end is posed, and the rest of it follows.
[[nodiscard]] constexpr bool reachesOut(const LimbPlace& limb) {
  return !isTrunk(limb) && limb.kind != LimbKind::chain;
}
/// Whether it bends at an elbow or a knee; all others keep their shape as they reach.
[[nodiscard]] constexpr bool hasElbowOrKnee(const LimbPlace& limb) {
  return isArm(limb) || isLeg(limb) || limb.kind == LimbKind::wing;
}

/// The place on the other side of the body; the same in the middle.
[[nodiscard]] LimbPlace mirrored(const LimbPlace& limb);

/// A chain of joints that is stretched as one.
struct Limb : LimbPlace {
  std::string id; ///< "left-arm", "front-left-leg", or "JOINT_A..JOINT_B" as the user wrote it.
  std::vector<NodeIndex> joints; ///< Nodes from the base to the last joint before the end, base first; at
                                 ///< least one. Twist joints and helper nodes between them are not listed:
                                 ///< they ride on their bone.
  NodeIndex endNode;       ///< The end joint (wrist, ankle, ...); need not be a descendant of `joints`. -1:
                           ///< estimated.
  Vec3 endOffset{0.0};     ///< Place of the end when endNode is -1: in the space of joints.back().
  double restLength = 0.0; ///< Sum of the bone lengths in the bind pose, world units.
  double confidence = 1.0; ///< 0..1.
  std::vector<std::string> reasons; ///< Why these joints: for the user.
  /// The first joint leads and the end stays: a serpent whose joints run from the head to the tail.
  bool ledByFirst = false;

  friend bool operator==(const Limb&, const Limb&) = default;
};

/// Null when there is no limb at the place.
[[nodiscard]] const Limb* limbAt(const std::vector<Limb>& limbs, const LimbPlace& place);

/// Position of the limb's end in world space.
[[nodiscard]] Vec3 endPosition(const Limb& limb, const std::vector<Mat4>& worlds);

/// Positions of the limb's joints, base first, and of its end: one more than Limb::joints.
[[nodiscard]] std::vector<Vec3> limbPoints(const Limb& limb, const std::vector<Mat4>& worlds);

/// Returns the end's place in a frame whose limbs may be stretched: an estimated end moves with the stretch
/// of the bone that it ends.
[[nodiscard]] Vec3 endPosition(const Limb& limb, const FrameState& frame);
[[nodiscard]] std::vector<Vec3> limbPoints(const Limb& limb, const FrameState& frame);

/// Places that a trail goes by: the place that leads, which is the limb's end where it is not led by its
/// first joint, the place that stays, which is the other one, and the limb's points from there to the one
/// that leads.
[[nodiscard]] Vec3 leadingPosition(const Limb& limb, const FrameState& frame);
[[nodiscard]] Vec3 stayingPosition(const Limb& limb, const FrameState& frame);
[[nodiscard]] std::vector<Vec3> pointsToLead(const Limb& limb, const FrameState& frame);

/// Its joints, then the end where that is a node: what has keys of the limb.
[[nodiscard]] std::vector<NodeIndex> jointsAndEnd(const Limb& limb);

/// The node at the place that stays.
[[nodiscard]] NodeIndex stayingNode(const Limb& limb);

/// Straight distance from the limb's base to its end in a frame.
[[nodiscard]] double limbLength(const Limb& limb, const FrameState& frame);

} // namespace stretch::rig

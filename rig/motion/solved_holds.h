#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/anim/frame_state.h"
#include "rig/controllers/offset_curve.h"
#include "rig/hold/hold.h"
#include "rig/reach/limb_reach.h"

namespace stretch::rig {

/// A HoldTime in seconds.
struct HoldSpan {
  double startSeconds = -std::numeric_limits<double>::infinity();
  double endSeconds = std::numeric_limits<double>::infinity();
  double blendInSeconds = 0.0; ///< Before the start.
  double blendOutSeconds = 0.0;
  double turnSeconds = 0.0; ///< Length of a loop that comes back to where it began: the blends go on across
                            ///< its seam. 0: none.

  /// 0 outside, 1 over the range, even in between.
  [[nodiscard]] double strengthAt(double timeSeconds) const;
  /// Whether it acts on the turns of a loop before (-1) and after (1) its own (0), too.
  [[nodiscard]] bool actsInTurn(int turn) const;
};

struct SolvedPin {
  std::size_t limb = 0; ///< Place in SolvedHolds::limbs.
  HoldSpan span;
  HeldPlace place;
  bool turns = true;
  double stretch = 1.0;
};

struct SolvedGrip {
  std::size_t limb = 0;
  Limb leader;
  HoldSpan span;
  std::optional<HeldPlace> relation; ///< Place of the follower, seen from the leader; none: as the source has
                                     ///< it.
  double stretch = 1.0;
};

struct SolvedPropHand {
  std::size_t limb = 0;
  OffsetCurve firmness;
  std::optional<HeldPlace> relation; ///< Place of the prop, seen from the hand; none: as the source has it.
};

struct SolvedProp {
  NodeIndex node;
  HoldSpan span;
  std::vector<SolvedPropHand> hands;
  Vec3 move{0.0}; ///< From where the source has it to where it is bound.
  Quat turn{1.0, 0.0, 0.0, 0.0};
  double stretch = 1.0;
};

/// The holds of one clip, ready for any time. Each list is as long as that of the Holds it was made from; a
/// hold that lacks its limb or node is empty (nothing).
struct SolvedHolds {
  std::vector<ReachingLimb> limbs; ///< That are held.
  std::vector<std::optional<SolvedPin>> pins;
  std::vector<std::optional<SolvedGrip>> grips;
  std::vector<std::optional<SolvedProp>> props;
  std::vector<NodeIndex> nodes; ///< Everything that is read or moved.

  [[nodiscard]] bool empty() const { return limbs.empty(); }
};

/// Returns the place of a limb's end in a frame; of an estimated end, how the last joint is turned.
[[nodiscard]] HeldPlace endPlace(const Limb& limb, const FrameState& frame);

/// Returns the place where a prop is bound, as a frame of the adjusted clip has it.
[[nodiscard]] HeldPlace boundPlace(const SolvedProp& prop, const FrameState& frame);

/// Whether a pin, a grip or a prop has all of a limb's end at a time.
[[nodiscard]] bool isFullyHeld(const SolvedHolds& holds, const Limb& limb, double timeSeconds);

/// How `place` is seen from `from`, and back: placedOn(from, seenFrom(from, place)) is `place`.
[[nodiscard]] HeldPlace seenFrom(const HeldPlace& from, const HeldPlace& place);
[[nodiscard]] HeldPlace placedOn(const HeldPlace& from, const HeldPlace& seen);
/// From `a` (0) to `b` (1): straight, and by the shortest turn.
[[nodiscard]] HeldPlace between(const HeldPlace& a, const HeldPlace& b, double share);

} // namespace stretch::rig

#pragma once

#include <string>

#include "app/auto/clip_ground.h"
#include "rig/trail/trail.h"

namespace stretch::app {

/// The limb's end seen from its base, at a frame that may lie past the clip's end: at the clip's start again
/// where it wraps, else as at its end.
[[nodiscard]] Vec3 reachAt(const ClipGround& ground, const std::string& limb, double frame);

/// Whole frames after the tip of a trail, at most so many, for which the limb holds the pose that it came to,
/// or goes on a little the same way, before it starts back. 0 where it stays there, for four tenths of a
/// second or more: it settles in it.
[[nodiscard]] double heldFor(const ClipGround& ground, const rig::Trail& trail, double mostFrames);

/// Whole frames for which a limb that goes round stays where it is after its tip, as in a clip on held poses,
/// and after which there is time for its way back within `mostFrames`: one frame where the limb itself is far
/// off by then, as a clip that is drawn on threes has it, else two.
[[nodiscard]] double stillFor(const ClipGround& ground, const rig::Trail& trail, double mostFrames);

/// Whether a limb is bent on purpose on most frames of the last two fifths of a range, and not so far that
/// its elbow would be thrown out where all of it gets so many times as long.
[[nodiscard]] bool isPosedBent(const ClipGround& ground, const rig::Limb& limb, const Vec2& range,
                               double scale);

/// Whether a limb is drawn in over a range: a leg that reaches far less at the tip; an arm that folds on its
/// way and ends with the hand nearer the trunk.
[[nodiscard]] bool foldsIn(const ClipGround& ground, const rig::Limb& limb, const Vec2& range);

/// Whether a hand that is well above the ground would come near it with the arm so many times as long.
[[nodiscard]] bool sweepsGround(const ClipGround& ground, const rig::Limb& limb, const Vec2& range,
                                double scale);

/// Whether a limb that points down is swung along the ground.
[[nodiscard]] bool goesLevel(const ClipGround& ground, const rig::Limb& limb, const Vec2& range);

/// Whether a foot is on the ground at all whole frames of a range, which goes on at the clip's start where
/// that wraps.
[[nodiscard]] bool isOnGround(const ClipGround& ground, const rig::Limb& leg, const Vec2& range);

/// Whether a body without legs keeps its head on the ground over a range, along which it crawls.
[[nodiscard]] bool crawls(const ClipGround& ground, const rig::Limb& limb, const Vec2& range);

/// Whether a leg hangs from a body that is in the air at the tip, where no leg stands, and does not reach for
/// the ground.
[[nodiscard]] bool isUpInTheAir(const ClipGround& ground, const rig::Limb& limb, const Vec2& range);

} // namespace stretch::app

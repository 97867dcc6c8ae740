#pragma once

#include <array>

#include "core/math/types.h"
#include "rig/ik/limb_shape.h"

namespace stretch::rig {

/// Fraction of a limb's length: a joint nearer than this to the line from base to end hardly tells which way
/// it bends.
inline constexpr double straightOfLength = 0.02;

/// Fraction of a limb's length for a joint that stands on the side to which the limb does not bend. From half
/// of it on it is taken for a limb that bends that way.
inline constexpr double overextendedOfLength = 0.25;

/// How far a limb of this length may reach for a target at `distance` (docs/controllers.md, Arms and legs):
/// the distance itself up to a soft zone before its full length, never more than that length, with a
/// continuous slope. A limb that stands straighter than the soft zone in its own pose (`poseReach`) keeps
/// that.
///
/// `softness`, 0 to 0.3 of the length, gives the soft zone that size for a straight limb too, so that its
/// joint does not pop out as it shortens. 0: the rule above. Whatever it is, a limb that is asked to stay
/// where its pose has it stays.
[[nodiscard]] double softReach(double length, double poseReach, double distance, double softness = 0.0);

/// A limb of two bones at one time, to be brought to a target by turning and scaling its bones. World space.
struct TwoBoneProblem {
  Vec3 base{0.0}; ///< The pose to be corrected: P0, P1, P2.
  Vec3 joint{0.0};
  Vec3 end{0.0};
  Vec3 target{0.0};     ///< F.
  Vec3 poleOffset{0.0}; ///< How far the pole is moved from its place; zero: the bend keeps its direction.
  /// Which way the limb bends where the pose is straight or overextended: a unit vector across its line, or
  /// zero.
  Vec3 usualBend{0.0};
  double stretchSwitch = 1.0; ///< k: 1 reaches every target, 0 leaves the bones as long as they are.
  double softness = 0.0;      ///< Of the soft zone; see softReach.
  bool isExact = false;       ///< Without a soft zone: a target within the limb's length is reached as it is.
};

/// Turns and scale that bring the limb there: each bone turns in world space about its start and is scaled by
/// `scale`.
struct TwoBoneShape {
  std::array<Quat, 2> turns{Quat(1.0, 0.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0)};
  double scale = 1.0; ///< Within [smallestStretch, largestStretch].
  Vec3 joint{0.0};    ///< Places that the middle joint and the end come to.
  Vec3 end{0.0};
  ShapeOutcome outcome = ShapeOutcome::reached; ///< clamped: the scale ended at a limit.
};

/// Exactly the identity where the target is the end and the pole has not moved. A limb whose bones or whose
/// line have no length stays as it is (degenerate). Finite for every finite input.
[[nodiscard]] TwoBoneShape solveTwoBone(const TwoBoneProblem& problem);

/// Returns the place of a limb's pole: half the limb's length before its joint, along the direction in which
/// it bends.
[[nodiscard]] Vec3 polePlace(const TwoBoneProblem& problem);

} // namespace stretch::rig

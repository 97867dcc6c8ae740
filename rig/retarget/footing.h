#pragma once

#include <vector>

#include "core/math/types.h"
#include "rig/retarget/standing.h"

namespace stretch::rig {

/// Finds where a point rests: slower than a quarter of the leg's length a second, for three frames at least.
/// One place and one time for each frame.
[[nodiscard]] std::vector<Stand> standsOf(const std::vector<Vec3>& places, const std::vector<double>& seconds,
                                          double legLength);

/// A foot over a clip, one entry for each frame. All but the heights is level: its y counts for nothing.
struct FootMotion {
  std::vector<Vec3> ankles;       ///< Ankles of the source, in the character's proportions.
  std::vector<Vec3> balls;        ///< Balls of the foot, likewise.
  std::vector<Vec3> toAnkle;      ///< From the character's ball to its ankle, as its foot is turned.
  std::vector<Vec3> wanted;       ///< Places where the ankle would be, if nothing had to stand.
  std::vector<Stand> ankleStands; ///< Times and places at which the source's heel and ball stand.
  std::vector<Stand> ballStands;
  std::vector<Stand> heldAnkles; ///< Those of them over which `ankles` and `balls` keep one place.
  std::vector<Stand> heldBalls;
  double shuffle = 0.0; ///< A foot that gets no farther from where it stood has shuffled: it goes as the
                        ///< source's does until it stands again.
};

/// Whether the foot touches the ground with anything, at each frame.
[[nodiscard]] std::vector<bool> standingFrames(const FootMotion& foot);

/// Returns the ankle's places: the point of the foot that stands in the source stands, on the mean as near to
/// the wanted place as it can, and between two stands the ankle is carried over smoothly.
[[nodiscard]] std::vector<Vec3> plantedAnkles(const FootMotion& foot);

/// A curve that is nowhere below the given one and rises and falls over `frames`.
[[nodiscard]] std::vector<double> easedAbove(const std::vector<double>& needed, std::size_t frames);

} // namespace stretch::rig

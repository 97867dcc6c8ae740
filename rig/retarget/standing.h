#pragma once

#include <cstddef>
#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// Frames over which a point keeps its place, both ends included.
struct Stand {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Frames in which a point of a foot stands on the ground: within 1 % of the height of its lowest place,
/// slower than 5 % of the height per second, three frames at least. One place for each frame; `height` > 0.
[[nodiscard]] std::vector<Stand> standingIn(const std::vector<Vec3>& places, double framesPerSecond,
                                            double height);

/// How far the point gets from where it is at the beginning of the frames, in the unit of the places.
[[nodiscard]] double wanderIn(const std::vector<Vec3>& places, const Stand& frames);

/// The places with those of each stand put to their middle, and moved over from the one to the next between
/// two stands.
[[nodiscard]] std::vector<Vec3> heldInPlace(const std::vector<Vec3>& places,
                                            const std::vector<Stand>& stands);

/// Carries the offsets at the ends of runs over to the frames between them, smoothly. The runs: at least one,
/// in order.
void carryOver(const std::vector<Stand>& runs, std::vector<Vec3>& offsets);

} // namespace stretch::rig

#pragma once

#include <cstddef>
#include <vector>

#include "core/math/types.h"

namespace stretch::app {

/// Frames from the first to the last, both included.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Stretches in which a point of a foot stands: within 1 % of the height of its lowest place, slower than
/// 5 % of the height per second, three frames at least. One place for each frame; `height` > 0.
[[nodiscard]] std::vector<Stretch> standingIn(const std::vector<Vec3>& places, double framesPerSecond,
                                              double height);

/// How far the point gets from where it is at the beginning of a stretch, in the unit of the places.
[[nodiscard]] double wanderIn(const std::vector<Vec3>& places, const Stretch& frames);

} // namespace stretch::app

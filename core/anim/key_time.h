#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace stretch {

/// Seconds as a key of a file stores them: in single precision.
[[nodiscard]] inline double asKeyTime(double timeSeconds) {
  return static_cast<double>(static_cast<float>(timeSeconds));
}

/// Seconds within which a time is at a border or at a key, because key times are stored in single precision:
/// more than the next such time to either side is away. For times up to the length of any clip.
[[nodiscard]] inline double keyTimeRounding(double timeSeconds) {
  return 2e-7 * std::max(1.0, std::abs(timeSeconds));
}

/// The last key time that is not after a time, and the first that is not before it: a border where a motion
/// jumps lies between two keys only where the inner one is not beyond it.
[[nodiscard]] inline double keyTimeAtMost(double timeSeconds) {
  const auto nearest = static_cast<float>(timeSeconds);
  const bool isLater = static_cast<double>(nearest) > timeSeconds;
  return isLater ? static_cast<double>(std::nextafter(nearest, -std::numeric_limits<float>::infinity()))
                 : static_cast<double>(nearest);
}

[[nodiscard]] inline double keyTimeAtLeast(double timeSeconds) {
  return -keyTimeAtMost(-timeSeconds);
}

} // namespace stretch

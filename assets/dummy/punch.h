#pragma once

#include <vector>

#include "assets/dummy/pose.h"

namespace stretch::assets {

inline constexpr double punchFramesPerSecond = 24.0;

/// The key poses of a one-two punch, frames 0 to 60: bouncing guard, left jab, right cross, back to the first
/// pose.
[[nodiscard]] std::vector<Pose> punchPoses();

/// The guard alone, bouncing from foot to foot: frames 0 to 16, a loop.
[[nodiscard]] std::vector<Pose> guardPoses();

} // namespace stretch::assets

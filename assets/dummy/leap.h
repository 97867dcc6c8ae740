#pragma once

#include <vector>

#include "assets/dummy/glb_writer.h"
#include "assets/dummy/pose.h"
#include "assets/dummy/skeleton.h"

namespace stretch::assets {

inline constexpr double leapFramesPerSecond = 24.0;

/// What is leapt over: a low ledge, the ledge that the hands catch, and the platform of the landing.
[[nodiscard]] std::vector<Prop> leapBlocks();

/// The key poses of a leap along +Z, frames 0 to 96: run-up, take-off at 36, hands on the second ledge from
/// 46 to 50, a landing on both feet at 63, a step out of it.
[[nodiscard]] std::vector<Pose> leapPoses();

[[nodiscard]] Motion leapMotion(const std::vector<Joint>& skeleton);

} // namespace stretch::assets

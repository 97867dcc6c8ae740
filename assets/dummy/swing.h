#pragma once

#include "assets/dummy/keying.h"
#include "assets/dummy/pose.h"
#include "assets/dummy/skeleton.h"

namespace stretch::assets {

inline constexpr double swingFramesPerSecond = 24.0;

/// The key poses of a baseball swing, frames 0 to 88: stance, leg kick, stride, contact at 38, the right hand
/// lets go at 44, a look after the ball. The pitcher stands at +X.
[[nodiscard]] std::vector<Pose> swingPoses();

/// The pose with its wrists where the hands that hold the bat (Control::holds) hold it.
[[nodiscard]] Pose withBatHeld(const std::vector<Joint>& skeleton, const Pose& pose);

/// Where a pose has the bat.
[[nodiscard]] PropPlace batPlace(const Pose& pose);

/// The swing, keyed; `batNode` is the bat's node.
[[nodiscard]] Motion swingMotion(const std::vector<Joint>& skeleton, int batNode);

} // namespace stretch::assets

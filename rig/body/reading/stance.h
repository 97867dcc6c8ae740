#pragma once

#include "rig/body/reading/biped_reading.h"

namespace stretch::rig::body {

/// How many legs a body stands on: what branches off the middle of the body, is no accessory, rises well
/// above the ground and reaches it, counted in pairs. The arms of an upright body are no legs however low
/// they reach, nor is what hangs beside its legs (coat tails). 0 where
/// nothing reaches the ground.
[[nodiscard]] int standingLegs(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading);

} // namespace stretch::rig::body

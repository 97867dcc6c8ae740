#pragma once

#include <string>
#include <vector>

#include "rig/hold/hold.h"
#include "tests/support/rig/moving_biped.h"

namespace stretch::test {

/// The punching biped with a thing that lies on the floor before it, by the name "bat", beside the skeleton.
[[nodiscard]] MovingBiped bipedWithBat(const SyntheticBiped& body = namedBody());

/// Full over a range of frames, with frames to come and to go beside it.
[[nodiscard]] rig::HoldTime heldOver(double startFrame, double endFrame, double inFrames = 0.0,
                                     double outFrames = 0.0);

/// A pin that keeps a limb's end where the clip has it at a frame.
[[nodiscard]] rig::Pin pinAt(const std::string& limb, const rig::HoldTime& time, double atFrame);

/// What is solved with holds on top of trails and adjustments.
[[nodiscard]] rig::MotionState held(rig::MotionInput input, const rig::Holds& holds);
[[nodiscard]] rig::MotionState held(const MovingBiped& moving, const rig::Holds& holds);

/// Place of the end of a limb.
[[nodiscard]] rig::HeldPlace endPlaceOf(const MovingBiped& moving, const std::string& limb,
                                        const FrameState& frame);

/// World units.
[[nodiscard]] double placesApart(const rig::HeldPlace& a, const rig::HeldPlace& b);
/// Radians.
[[nodiscard]] double turnApart(const rig::HeldPlace& a, const rig::HeldPlace& b);

/// The ends of arms and legs.
inline const std::vector<std::string> handsAndFeet{"left-arm", "right-arm", "left-leg", "right-leg"};

} // namespace stretch::test

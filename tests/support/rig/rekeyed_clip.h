#pragma once

#include "rig/rekey/rekey.h"
#include "tests/support/rig/moving_biped.h"

namespace stretch::test {

/// A clip with its trails keyed in, beside the motion that the keys are to follow.
struct Rekeyed {
  rig::MotionState motion;
  rig::RekeyedClip keys;
  Clip clip;
};

/// With the tolerance of 1e-4 of the height that re-keying promises, halved as saving does.
[[nodiscard]] Rekeyed rekeyedOf(const MovingBiped& moving, const std::vector<rig::Trail>& trails,
                                const rig::RekeyOptions& options = {}, bool loops = false);

/// The character as another player of the clip's tracks shows it.
[[nodiscard]] FrameState poseOf(const MovingBiped& moving, const Clip& clip, double frame);

/// Largest distance of any joint from the exact motion at every frame and half frame of [first, last].
[[nodiscard]] double worstMiss(const MovingBiped& moving, const Rekeyed& rekeyed, int first, int last);

/// Null when the clip does not animate it.
[[nodiscard]] const Track* sourceTrack(const Clip& clip, NodeIndex node, Channel channel);

/// All numbers of the key at exactly this time, tangents included; empty without such a key.
[[nodiscard]] std::vector<float> keyNumbers(const Track& track, float timeSeconds);

/// K at a time, as the keys interpolate.
[[nodiscard]] Mat3 stretchOf(const rig::StretchKeys& keys, double timeSeconds);

} // namespace stretch::test

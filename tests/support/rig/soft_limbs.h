#pragma once

#include "rig/motion/motion.h"
#include "tests/support/rig/moving_biped.h"

namespace stretch::test {

/// Factors of every bone of a limb along itself, and across it along and perpendicular to `acrossWorld`.
struct SoftBones {
  double along = 1.0;
  double withLoad = 1.0;
  double sideways = 1.0;
  Vec3 acrossWorld{0.0, 1.0, 0.0};
  double planted = 0.0;
  double kept = 0.0;
};

/// The weight of a limb over the whole clip, one sample for each frame; `bonesAt(frame)` answers its
/// SoftBones.
template <typename BonesAt>
rig::LimbWeight softLimb(const MovingBiped& moving, const std::string& limb, BonesAt&& bonesAt);

/// One sample from the limb as it stands in a frame.
[[nodiscard]] rig::WeightSample softSample(const rig::Limb& limb, const FrameState& frame,
                                           const SoftBones& bones);

/// Trails and weight, solved.
[[nodiscard]] rig::MotionState softMotion(const MovingBiped& moving, const std::vector<rig::Trail>& trails,
                                          const std::vector<rig::LimbWeight>& weights);

template <typename BonesAt>
rig::LimbWeight softLimb(const MovingBiped& moving, const std::string& limb, BonesAt&& bonesAt) {
  rig::LimbWeight weight{limb, {}, moving.clip.startSeconds, moving.clip.endSeconds, 0.0, 0.0};
  for (double frame = 0.0; frame <= moving.clip.endSeconds * moving.clip.framesPerSecond + 1e-6;
       frame += 1.0) {
    weight.samples.push_back(softSample(moving.limb(limb), sourceAtFrame(moving, frame), bonesAt(frame)));
  }
  return weight;
}

} // namespace stretch::test

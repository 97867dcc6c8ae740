#pragma once

#include <vector>

#include "app/weight/weight_input.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// The limbs of a clip with its trails, sampled for the elastic model: where each joint is, metres of a
/// character of characterHeightMetres, and how its space lies.
struct SampledClip {
  double samplesPerSecond = 30.0;
  std::vector<double> seconds; ///< Of the samples, even; about 24 to 40 of them per second, frames among
                               ///< them.
  struct OfLimb {
    rig::Limb limb;
    std::vector<std::vector<Vec3>> joints;  ///< For each sample: base first, end last.
    std::vector<std::vector<Mat3>> toJoint; ///< For each sample: world directions seen from each joint.
    std::vector<double> lowest;             ///< Height along +Y of the lowest joint of hand or foot, metres.
  };
  std::vector<OfLimb> limbs; ///< Those with weight, and the legs.
};

/// `motion`: trails of the clip, without weight.
[[nodiscard]] SampledClip sampleClip(const WeightInput& input, const rig::MotionState& motion);

} // namespace stretch::app

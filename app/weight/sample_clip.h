#pragma once

#include <memory>
#include <vector>

#include "app/weight/weight_settings.h"
#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// Input from which the weight of the limbs of one clip is worked out.
struct WeightInput {
  std::shared_ptr<const Scene> scene;
  const Clip* clip = nullptr;
  std::vector<rig::Limb> limbs;      ///< All limbs that weight may name, chains included.
  double size = 1.0;                 ///< rig::Body::size, world units, > 0.
  bool loops = false;                ///< The clip goes on with its own beginning.
  std::vector<WeightedLimb> weights; ///< Weights of this clip; what is off or names no limb is passed over.

  [[nodiscard]] double metresPerUnit() const { return characterSizeMetres / size; }
};

/// Places in WeightInput::weights of the limbs that give way: on, and there.
[[nodiscard]] std::vector<std::size_t> activeWeights(const WeightInput& input);

/// Against gravity, unit: of the first limb that gives way and has any; without one +Y. What stands, stands
/// along it.
[[nodiscard]] Vec3 upOf(const WeightInput& input);

/// The limbs of a clip with its trails, sampled for the elastic model: where each joint is, metres of a
/// character of characterSizeMetres, and how its space lies.
struct SampledClip {
  double samplesPerSecond = 120.0;
  std::vector<double> seconds; ///< Times of the samples, even, about 120 per second, from the clip's first
                               ///< key to its last (of a clip of more than half an hour the first part).
  struct OfLimb {
    rig::Limb limb;
    std::vector<std::vector<Vec3>> joints;  ///< For each sample: base first, end last.
    std::vector<std::vector<Mat3>> toJoint; ///< For each sample: world directions seen from each joint.
    std::vector<double> lowest; ///< Height along upOf of the lowest joint of hand or foot, metres.
  };
  std::vector<OfLimb> limbs; ///< Those with weight, and the legs.
};

/// `motion`: trails of the clip, without weight.
[[nodiscard]] SampledClip sampleClip(const WeightInput& input, const rig::MotionState& motion);

/// How long and how thick each bone of a limb is in the bind pose, world units.
struct LimbSize {
  std::vector<double> lengths; ///< One for each bone, > 0.
  std::vector<double> widths;  ///< Mean shape diameter of the surface that follows the bone, > 0; where the
                               ///< limb has no surface, a sixth of the bone's length.
};

/// `others`: all limbs of the character: what follows them does not count.
[[nodiscard]] LimbSize limbSize(const Scene& scene, const rig::Limb& limb,
                                const std::vector<rig::Limb>& others);

} // namespace stretch::app

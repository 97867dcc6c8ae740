#include "rig/motion/solve.h"

#include <algorithm>
#include <utility>

#include "rig/body/detection.h"
#include "rig/motion/order.h"
#include "rig/motion/solve_steps.h"

namespace stretch::rig {

namespace {

bool fits(const LimbWeight& weight, const Limb& limb) {
  return std::all_of(weight.samples.begin(), weight.samples.end(),
                     [&](const WeightSample& sample) { return sample.strains.size() == limb.joints.size(); });
}

} // namespace

void setWeight(const MotionInput& input, std::vector<LimbWeight> weights, MotionState& motion) {
  std::erase_if(weights, [&](const LimbWeight& one) {
    const Limb* const limb = limbOf(input, one.limb);
    return limb == nullptr || !fits(one, *limb);
  });
  const auto has = [&](const std::string& id) {
    return std::any_of(weights.begin(), weights.end(), [&](const LimbWeight& one) { return one.limb == id; });
  };
  const bool anyLeg = std::any_of(weights.begin(), weights.end(),
                                  [&](const LimbWeight& one) { return isLeg(*limbOf(input, one.limb)); });
  for (const Limb& limb : input.limbs) {
    if (anyLeg && isLeg(limb) && !limb.joints.empty() && !has(limb.id)) {
      weights.push_back({limb.id, {}, 0.0, 0.0, 0.0, 0.0});
    }
  }
  const BindPlaces places = bindPlaces(*input.scene);
  motion.weights.clear();
  for (LimbWeight& one : weights) {
    const Limb& limb = *limbOf(input, one.limb);
    motion.weights.push_back({std::move(one), limb, limbTopology(*input.scene, limb, input.limbs, places)});
  }
  std::vector<ActingLimb> acting;
  for (const SolvedWeight& solved : motion.weights) {
    acting.push_back({&solved.limb, 0.0});
  }
  motion.weights = inOrder(std::move(motion.weights), actingOrder(*input.scene, acting));
}

} // namespace stretch::rig

#include "rig/motion/solve.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "rig/body/reading/detection.h"
#include "rig/motion/order.h"
#include "rig/motion/part_motion.h"
#include "rig/motion/solve_steps.h"

namespace stretch::rig {

namespace {

bool fits(const LimbWeight& weight, const Limb& limb) {
  return std::ranges::all_of(weight.samples, [&](const WeightSample& sample) {
    return sample.strains.size() == limb.joints.size();
  });
}

void append(const std::vector<NodeIndex>& some, std::vector<NodeIndex>& nodes) {
  nodes.insert(nodes.end(), some.begin(), some.end());
}

// The hand or foot of a limb: its end, or the last bone where there is none, what moves with that, and all
// below.
std::vector<NodeIndex> endNodes(const Scene& scene, const Limb& limb, const LimbTopology& topology) {
  std::vector<NodeIndex> nodes = topology.companions;
  if (limb.endNode.exists() || !limb.joints.empty()) {
    nodes.push_back(limb.endNode.exists() ? limb.endNode : limb.joints.back());
  }
  return withSubtrees(scene, nodes);
}

std::vector<NodeIndex> without(const std::vector<NodeIndex>& nodes, const std::vector<NodeIndex>& others) {
  std::vector<NodeIndex> rest; // both ascending
  std::set_difference(nodes.begin(), nodes.end(), others.begin(), others.end(), std::back_inserter(rest));
  return rest;
}

BodyOutline outlineOfBody(const MotionInput& input, const std::vector<SolvedWeight>& weights) {
  const Scene& scene = *input.scene;
  std::vector<NodeIndex> hips;
  if (input.hips.exists()) {
    hips.push_back(input.hips);
  }
  std::vector<NodeIndex> body = hips;
  for (const Limb& limb : input.limbs) {
    append(limb.joints, body);
    append(endNodes(scene, limb, {}), body);
  }
  std::vector<NodeIndex> ownWay;
  for (const SolvedWeight& solved : weights) {
    append(touchedNodes(solved.limb, solved.topology), ownWay);
  }
  BodyOutline outline = outlineOf(scene);
  outline.body = outlined(outline, withSubtrees(scene, body));
  outline.riding = without(outlined(outline, withSubtrees(scene, hips)), withSubtrees(scene, ownWay));
  return outline;
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
  const bool anyLeg =
      std::ranges::any_of(weights, [&](const LimbWeight& one) { return isLeg(*limbOf(input, one.limb)); });
  for (const Limb& limb : input.limbs) {
    if (anyLeg && isLeg(limb) && !limb.joints.empty() && !has(limb.id)) {
      weights.push_back({limb.id, {}, 0.0, 0.0, 0.0, 0.0});
    }
  }
  const BindPlaces places = bindPlaces(*input.scene);
  motion.weights.clear();
  for (LimbWeight& one : weights) {
    const Limb& limb = *limbOf(input, one.limb);
    motion.weights.push_back(
        {std::move(one), limb, limbTopology(*input.scene, limb, input.limbs, places), {}});
  }
  motion.outline = motion.weights.empty() ? BodyOutline{} : outlineOfBody(input, motion.weights);
  for (SolvedWeight& solved : motion.weights) {
    solved.ends = outlined(motion.outline, endNodes(*input.scene, solved.limb, solved.topology));
  }
  std::vector<ActingLimb> acting;
  for (const SolvedWeight& solved : motion.weights) {
    acting.push_back({&solved.limb, 0.0});
  }
  motion.weights = inOrder(std::move(motion.weights), actingOrder(*input.scene, acting));
}

} // namespace stretch::rig

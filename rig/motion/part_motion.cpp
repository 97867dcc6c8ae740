#include "rig/motion/part_motion.h"

#include <algorithm>
#include <utility>

#include "rig/adjust/apply_adjustments.h"
#include "rig/motion/evaluate.h"

namespace stretch::rig {

namespace {

// What adjustments, trails and weights are worked out from, beside the nodes that they move.
void addGround(const Scene& scene, const MotionState& motion, std::vector<NodeIndex>& nodes) {
  const std::vector<NodeIndex> moved = movedNodes(scene, motion);
  nodes.insert(nodes.end(), moved.begin(), moved.end());
  nodes.insert(nodes.end(), motion.outline.body.begin(), motion.outline.body.end());
  if (motion.hips.exists()) {
    nodes.push_back(motion.hips);
  }
}

NodeSampler samplerOf(const Scene& scene, const Clip& clip, const MotionState& motion,
                      std::vector<NodeIndex> nodes) {
  addGround(scene, motion, nodes);
  return {scene, clip, nodes};
}

} // namespace

PartMotion::PartMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                       std::vector<NodeIndex> nodes)
    : clip_(clip), motion_(motion), sampler_(samplerOf(scene, clip, motion, std::move(nodes))),
      skeleton_(sampler_.skeleton()) {}

void PartMotion::source(double timeSeconds, FrameState& frame) const {
  sampler_.sample(std::min(timeSeconds, clip_.endSeconds), frame);
}

void PartMotion::moved(double timeSeconds, FrameState& frame) const {
  source(timeSeconds, frame);
  move(frame);
  frame.timeSeconds = timeSeconds;
}

void PartMotion::move(FrameState& frame) const {
  applyAdjustments(skeleton_, motion_.adjustments, frame);
  applyMotion(skeleton_, motion_, frame);
}

std::vector<NodeIndex> movedNodes(const Scene& scene, const MotionState& motion) {
  std::vector<NodeIndex> nodes = motion.adjustments.nodes;
  nodes.insert(nodes.end(), motion.holds.nodes.begin(), motion.holds.nodes.end());
  const auto add = [&](const Limb& limb, const LimbTopology& topology) {
    const std::vector<NodeIndex> touched = touchedNodes(limb, topology);
    nodes.insert(nodes.end(), touched.begin(), touched.end());
  };
  for (const SolvedTrail& trail : motion.trails) {
    if (trail.active) {
      add(trail.limb, trail.topology);
    }
  }
  for (const SolvedWeight& weight : motion.weights) {
    add(weight.limb, weight.topology);
    if (isLeg(weight.limb) && motion.hips.exists()) {
      nodes.push_back(motion.hips);
    }
  }
  return withSubtrees(scene, nodes);
}

} // namespace stretch::rig

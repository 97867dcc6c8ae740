#include "rig/rekey/joint_check.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/transform.h"
#include "rig/motion/part_motion.h"

namespace stretch::rig {

namespace {

// How far a node, and the mesh that follows it, is from where it should be.
double nodeMiss(const Mat4& world, const Mat4& wanted, double reach) {
  const Mat4 difference = world - wanted;
  double turned = 0.0;
  for (int column = 0; column < 3; ++column) {
    const Vec3 axis(difference[column]);
    turned += glm::dot(axis, axis);
  }
  // Of a turn by a small angle the squares of the three axes' ways add up to twice the angle's.
  return glm::length(Vec3(difference[3])) + reach * std::sqrt(0.5 * turned);
}

} // namespace

JointCheck::JointCheck(ExactMotion& exact, const PartKeys& keys) : exact_(exact) {
  const Scene& scene = exact.scene();
  std::vector<NodeIndex> changed;
  for (const ChangedChannel& channel : keys.channels) {
    changed.push_back(channel.node);
  }
  std::vector<int> places(scene.nodes.size(), -1);
  for (const NodeIndex node : withSubtrees(scene, changed)) {
    places[at(node)] = 0;
  }
  for (const NodeIndex node : parentsFirst(scene)) {
    if (places[at(node)] < 0) {
      continue;
    }
    const NodeIndex parent = scene.nodes[at(node)].parent;
    places[at(node)] = static_cast<int>(steps_.size());
    steps_.push_back({node, parent.exists() ? places[at(parent)] : -1, exact.reachOf(at(node))});
  }
  for (const ChangedChannel& channel : keys.channels) {
    stepOf_.push_back(at(places[at(channel.node)]));
  }
  locals_.resize(steps_.size());
  usesMatrix_.resize(steps_.size());
  worlds_.resize(steps_.size());
}

double JointCheck::missAt(const PartKeys& keys, const std::vector<ChannelSpan>& spans, double timeSeconds) {
  const FrameState& wanted = exact_.at(timeSeconds);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    locals_[i] = wanted.pose.locals[at(steps_[i].node)];
    usesMatrix_[i] = wanted.pose.usesMatrix[at(steps_[i].node)];
  }
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Channel channel = keys.channels[i].channel;
    setChannelValue(locals_[stepOf_[i]], channel, spans[i].at(channel, timeSeconds));
    usesMatrix_[stepOf_[i]] = false;
  }
  const std::vector<Node>& nodes = exact_.scene().nodes;
  double miss = 0.0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const NodeIndex parent = nodes[at(step.node)].parent;
    const Mat4 local = usesMatrix_[i] ? *nodes[at(step.node)].matrix : toMatrix(locals_[i]);
    const Mat4* const above = step.parent >= 0  ? &worlds_[at(step.parent)]
                              : parent.exists() ? &wanted.worlds[at(parent)]
                                                : nullptr;
    worlds_[i] = above != nullptr ? *above * local : local;
    miss = std::max(miss, nodeMiss(worlds_[i], wanted.worlds[at(step.node)], step.reach));
  }
  return miss;
}

} // namespace stretch::rig

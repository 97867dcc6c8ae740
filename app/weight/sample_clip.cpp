#include "app/weight/sample_clip.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/anim/frame_state.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"
#include "skinning/geometry/bone_widths.h"

namespace stretch::app {

namespace {

// Even times from a clip's first key to its last, about 120 a second, whatever rate the clip is counted in:
// its weight is the same at every rate.
void setTimes(const Clip& clip, SampledClip& sampled) {
  constexpr double about = 120.0; // samples per second
  constexpr double most = 250000.0;
  const double lasts = clip.endSeconds - clip.startSeconds;
  const double steps = std::round(lasts * about);
  sampled.samplesPerSecond = steps > 0.0 ? steps / lasts : about;
  for (double i = 0.0; i <= std::min(steps, most); i += 1.0) {
    sampled.seconds.push_back(clip.startSeconds + i / sampled.samplesPerSecond);
  }
}

void collectSubtree(const Scene& scene, NodeIndex node, std::vector<NodeIndex>& nodes) {
  nodes.push_back(node);
  for (const NodeIndex child : scene.nodes[at(node)].children) {
    collectSubtree(scene, child, nodes);
  }
}

// Whether a limb has weight, or is a leg: what stands carries what does not.
bool isSampled(const WeightInput& input, const rig::Limb& limb) {
  const std::vector<std::size_t> active = activeWeights(input);
  return !limb.joints.empty() && (isLeg(limb) || std::ranges::any_of(active, [&](std::size_t i) {
                                    return input.weights[i].limb == limb.id;
                                  }));
}

// Adds one sample of a limb. Lowest: on tiptoe the ankle is high, but the foot stands all the same.
void addSample(const FrameState& frame, const std::vector<NodeIndex>& endNodes, double metresPerUnit,
               const Vec3& up, SampledClip::OfLimb& one) {
  std::vector<Vec3> joints = rig::limbPoints(one.limb, frame);
  std::vector<Mat3> toJoint;
  for (const NodeIndex joint : one.limb.joints) {
    const Mat3 world(frame.worlds[at(joint)]);
    toJoint.push_back(glm::determinant(world) != 0.0 ? glm::inverse(world) : Mat3(1.0));
  }
  double lowest = glm::dot(joints.back(), up);
  for (const NodeIndex node : endNodes) {
    lowest = std::min(lowest, glm::dot(positionOf(frame.worlds[at(node)]), up));
  }
  for (Vec3& joint : joints) {
    joint *= metresPerUnit;
  }
  one.lowest.push_back(lowest * metresPerUnit);
  one.joints.push_back(std::move(joints));
  one.toJoint.push_back(std::move(toJoint));
}

// The bone that each node's surface follows; -1 for none of the limb's.
std::vector<int> bonesOfNodes(const Scene& scene, const rig::Limb& limb,
                              const std::vector<rig::Limb>& others) {
  constexpr int undecided = -2;
  std::vector<int> own(scene.nodes.size(), undecided);
  for (const rig::Limb& other : others) {
    for (const NodeIndex joint : other.joints) {
      own[at(joint)] = -1;
    }
  }
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    own[at(limb.joints[i])] = static_cast<int>(i);
  }
  if (limb.endNode.exists()) {
    own[at(limb.endNode)] = -1;
  }
  std::vector<int> bones(scene.nodes.size(), -1);
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    bones[at(node)] = own[at(node)] != undecided ? own[at(node)] : (parent.exists() ? bones[at(parent)] : -1);
  }
  return bones;
}

} // namespace

SampledClip sampleClip(const WeightInput& input, const rig::MotionState& motion) {
  const Clip& clip = *input.clip;
  SampledClip sampled;
  setTimes(clip, sampled);
  std::vector<std::vector<NodeIndex>> endNodes;
  for (const rig::Limb& limb : input.limbs) {
    if (isSampled(input, limb)) {
      sampled.limbs.push_back({limb, {}, {}, {}});
      endNodes.emplace_back();
      if (limb.endNode.exists()) {
        collectSubtree(*input.scene, limb.endNode, endNodes.back());
      }
    }
  }
  const Vec3 up = upOf(input);
  for (const double seconds : sampled.seconds) {
    const FrameState frame = rig::evaluateMotion(*input.scene, clip, motion, seconds);
    for (std::size_t i = 0; i < sampled.limbs.size(); ++i) {
      addSample(frame, endNodes[i], input.metresPerUnit(), up, sampled.limbs[i]);
    }
  }
  return sampled;
}

LimbSize limbSize(const Scene& scene, const rig::Limb& limb, const std::vector<rig::Limb>& others) {
  FrameState bind = frameOf(scene, restPose(scene), 0.0);
  bind.worlds = rig::bindPoseWorlds(scene);
  const std::vector<Vec3> points = rig::limbPoints(limb, bind.worlds);
  LimbSize size;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    constexpr double shortest = 1e-6; // of the limb
    size.lengths.push_back(
        std::max({glm::length(points[i + 1] - points[i]), shortest * limb.restLength, 1e-12}));
  }
  size.widths = skinning::boneWidths(scene, bind, bonesOfNodes(scene, limb, others), size.lengths.size());
  for (std::size_t i = 0; i < size.widths.size(); ++i) {
    size.widths[i] = size.widths[i] > 0.0 ? size.widths[i] : size.lengths[i] / 6.0;
  }
  return size;
}

} // namespace stretch::app

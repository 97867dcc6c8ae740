#include "app/weight/limb_widths.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "rig/body/detection.h"
#include "rig/limb.h"
#include "skinning/geometry/bone_widths.h"

namespace stretch::app {

namespace {

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

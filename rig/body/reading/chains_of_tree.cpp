#include <algorithm>

#include "rig/body/reading/limb_assembly.h"
#include "rig/body/reading/plan_reading.h"

namespace stretch::rig::body {

namespace {

// As chains are named: by the joint's name where that is its alone.
std::string jointReference(const Scene& scene, NodeIndex node) {
  const std::string& name = scene.nodes[at(node)].name;
  const auto same = std::ranges::count(scene.nodes, name, &Node::name);
  return name.empty() || same > 1 ? "#" + std::to_string(node.value) : name;
}

} // namespace

std::vector<Limb> chainsOfTree(const Scene& scene, const BindPose& bindPose, const BodyView& view) {
  constexpr std::size_t mostChains = 60;
  constexpr std::size_t mostJoints = 300; // as of any limb
  std::vector<Limb> chains;
  for (int joint = 0; joint < view.count(); ++joint) {
    const int parent = view.parentOf(joint);
    if (parent >= 0 && view.childrenOf(parent).size() == 1) {
      continue;
    }
    int end = joint;
    while (view.childrenOf(end).size() == 1) {
      end = view.childrenOf(end).front();
    }
    if (end == joint) {
      continue;
    }
    const LimbEnd last{view.nodes[static_cast<std::size_t>(end)], view.at(end)};
    std::vector<NodeIndex> joints;
    for (int above = view.parentOf(end); above != parent; above = view.parentOf(above)) {
      joints.insert(joints.begin(), view.nodes[static_cast<std::size_t>(above)]);
    }
    const std::string id = jointReference(scene, joints.front()) + ".." + jointReference(scene, last.node);
    Limb chain = makeLimb({}, std::move(joints), last, bindPose.worlds);
    chain.id = id;
    if (isSound(chain) && chain.joints.size() <= mostJoints && chain.restLength > 0.03 * view.size) {
      chain.confidence = 0.6;
      chain.reasons = {"a row of joints between branchings"};
      chains.push_back(std::move(chain));
    }
  }
  std::ranges::stable_sort(chains, std::ranges::greater{}, &Limb::restLength);
  chains.resize(std::min(chains.size(), mostChains));
  return chains;
}

} // namespace stretch::rig::body

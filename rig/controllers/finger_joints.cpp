#include "rig/controllers/finger_joints.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace stretch::rig {

namespace {

std::vector<NodeIndex> jointChildren(const Scene& scene, const std::set<NodeIndex>& skinned, NodeIndex node) {
  std::vector<NodeIndex> children;
  std::ranges::copy_if(scene.nodes[at(node)].children, std::back_inserter(children), [&](NodeIndex child) {
    const Node& holder = scene.nodes[at(child)];
    return !holder.isBindLeaf && (skinned.contains(child) || skinned.empty());
  });
  return children;
}

// Chains of joints below the hand, each without branches: a branching joint is part of the palm.
void collectChains(const Scene& scene, const std::set<NodeIndex>& skinned, NodeIndex hand,
                   std::vector<std::vector<NodeIndex>>& chains) {
  for (const NodeIndex first : jointChildren(scene, skinned, hand)) {
    std::vector<NodeIndex> chain{first};
    std::vector<NodeIndex> next = jointChildren(scene, skinned, first);
    while (next.size() == 1) {
      chain.push_back(next.front());
      next = jointChildren(scene, skinned, chain.back());
    }
    if (next.empty()) {
      chains.push_back(std::move(chain));
    } else {
      collectChains(scene, skinned, chain.back(), chains);
    }
  }
}

// What is held in the hand of a skinned character hangs there by a joint of its own, with a mesh that no skin
// bends.
bool holdsProp(const Scene& scene, NodeIndex node) {
  const Node& holder = scene.nodes[at(node)];
  return (holder.mesh >= 0 && holder.skin < 0) ||
         std::ranges::any_of(holder.children, [&](NodeIndex child) { return holdsProp(scene, child); });
}

} // namespace

std::vector<std::vector<NodeIndex>> fingerChains(const Scene& scene, const Limb& arm) {
  std::vector<std::vector<NodeIndex>> chains;
  const std::set<NodeIndex> skinned = skinJoints(scene);
  collectChains(scene, skinned, arm.endNode.exists() ? arm.endNode : arm.joints.back(), chains);
  std::erase_if(chains, [&](const std::vector<NodeIndex>& chain) {
    return !skinned.empty() && holdsProp(scene, chain.front());
  });
  // Joints that only twist a forearm stand alone.
  const auto articulated = std::ranges::count_if(chains, [](const auto& chain) { return chain.size() > 1; });
  const bool isHand = arm.endNode.exists() || (!skinned.empty() && articulated > 1);
  return isHand ? chains : std::vector<std::vector<NodeIndex>>{};
}

std::vector<NodeIndex> fingerJoints(const Scene& scene, const Limb& arm) {
  std::vector<NodeIndex> joints;
  for (const std::vector<NodeIndex>& chain : fingerChains(scene, arm)) {
    joints.insert(joints.end(), chain.begin(), chain.end());
  }
  return joints;
}

} // namespace stretch::rig

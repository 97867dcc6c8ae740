#include "rig/body/evidence/skeletons.h"

#include <algorithm>
#include <set>

namespace stretch::rig::body {

namespace {

// Joints of skins, and how many each node carries, itself counted.
struct Joints {
  std::set<NodeIndex> all;
  std::vector<int> carried;

  explicit Joints(const Scene& scene) : all(skinJoints(scene)), carried(scene.nodes.size(), 0) {
    const std::vector<NodeIndex> order = parentsFirst(scene);
    for (auto lowest = order.rbegin(); lowest != order.rend(); ++lowest) {
      carried[at(*lowest)] += all.contains(*lowest) ? 1 : 0;
      if (const NodeIndex parent = scene.nodes[at(*lowest)].parent; parent.exists()) {
        carried[at(parent)] += carried[at(*lowest)];
      }
    }
  }

  // Of some joints those that carry most, in the order of the file.
  [[nodiscard]] std::vector<NodeIndex> largest(std::vector<NodeIndex> tops) const {
    constexpr std::size_t mostSkeletons = 8; // keeps a crowd from costing much
    std::ranges::stable_sort(tops, std::ranges::greater{}, [&](NodeIndex top) { return carried[at(top)]; });
    tops.resize(std::min(tops.size(), mostSkeletons));
    std::ranges::sort(tops);
    return tops;
  }
};

} // namespace

std::vector<NodeIndex> skeletonsApart(const Scene& scene) {
  constexpr int leastJoints = 5;
  const Joints joints(scene);
  std::vector<NodeIndex> tops;
  std::vector<bool> isBelow(scene.nodes.size(), false); // another joint
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    isBelow[at(node)] = parent.exists() && (isBelow[at(parent)] || joints.all.contains(parent));
    if (joints.all.contains(node) && !isBelow[at(node)] && joints.carried[at(node)] >= leastJoints) {
      tops.push_back(node);
    }
  }
  return joints.largest(std::move(tops));
}

std::vector<NodeIndex> skeletonsUnder(const Scene& scene, NodeIndex top) {
  constexpr int leastJoints = 10;
  const Joints joints(scene);
  while (scene.nodes[at(top)].children.size() == 1) {
    top = scene.nodes[at(top)].children.front();
  }
  std::vector<NodeIndex> tops;
  std::ranges::copy_if(scene.nodes[at(top)].children, std::back_inserter(tops),
                       [&](NodeIndex child) { return joints.carried[at(child)] >= leastJoints; });
  return joints.largest(std::move(tops));
}

} // namespace stretch::rig::body

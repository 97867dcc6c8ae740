#include "rig/body/evidence/skeletons.h"

#include <algorithm>
#include <set>

namespace stretch::rig::body {

std::vector<NodeIndex> skeletonsApart(const Scene& scene) {
  constexpr int leastJoints = 5;
  constexpr std::size_t mostSkeletons = 8; // keeps a crowd from costing much
  const std::set<NodeIndex> joints = skinJoints(scene);
  std::vector<NodeIndex> topOf(scene.nodes.size()); // the topmost joint at or above each node; -1: none
  std::vector<int> carried(scene.nodes.size(), 0);
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    const bool isJoint = joints.contains(node);
    const NodeIndex above = parent.exists() ? topOf[at(parent)] : NodeIndex::none;
    topOf[at(node)] = !above.exists() && isJoint ? node : above;
    if (isJoint) {
      ++carried[at(topOf[at(node)])];
    }
  }
  std::vector<NodeIndex> tops;
  for (std::size_t node = 0; node < carried.size(); ++node) {
    if (carried[node] >= leastJoints) {
      tops.emplace_back(node);
    }
  }
  std::ranges::stable_sort(tops, std::ranges::greater{}, [&](NodeIndex top) { return carried[at(top)]; });
  tops.resize(std::min(tops.size(), mostSkeletons));
  std::ranges::sort(tops);
  return tops;
}

} // namespace stretch::rig::body

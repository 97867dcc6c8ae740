#include "rig/body/evidence/skeletons.h"

#include <set>

namespace stretch::rig::body {

std::vector<NodeIndex> skeletonsApart(const Scene& scene) {
  constexpr int leastJoints = 10;
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
  for (std::size_t node = 0; node < carried.size() && tops.size() < mostSkeletons; ++node) {
    if (carried[node] >= leastJoints) {
      tops.emplace_back(node);
    }
  }
  return tops;
}

} // namespace stretch::rig::body

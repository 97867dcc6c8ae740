#include "rig/body/evidence/skeletons.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"

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

std::vector<NodeIndex> copiesOf(const Scene& scene, const BindPose& bindPose,
                                const std::vector<NodeIndex>& own) {
  constexpr double samePlace = 1e-3; // of how far they reach
  Bounds bounds;
  for (const NodeIndex joint : own) {
    bounds.add(positionOf(bindPose.worlds[at(joint)]));
  }
  const std::set<NodeIndex> joints = skinJoints(scene);
  const auto isTwin = [&](NodeIndex node) {
    const Vec3 place = positionOf(bindPose.worlds[at(node)]);
    return std::ranges::any_of(own, [&](NodeIndex joint) {
      return glm::distance(place, positionOf(bindPose.worlds[at(joint)])) <
             samePlace * bounds.largestExtent();
    });
  };
  std::vector<NodeIndex> copies;
  for (const NodeIndex top : skeletonsApart(scene)) {
    std::vector<NodeIndex> nodes = withSubtrees(scene, {top});
    std::erase_if(nodes, [&](NodeIndex node) { return !joints.contains(node); });
    const bool isOwn =
        std::ranges::any_of(own, [&](NodeIndex joint) { return isAncestorOrSelf(scene, top, joint); });
    const auto twins = static_cast<std::size_t>(std::ranges::count_if(nodes, isTwin));
    if (!isOwn && twins > 0 && 2 * twins >= std::min(nodes.size(), own.size())) {
      copies.push_back(top);
    }
  }
  return copies;
}

} // namespace stretch::rig::body

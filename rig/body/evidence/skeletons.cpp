#include "rig/body/evidence/skeletons.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/finite.h"

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

// For each node the first joint in its subtree, and from how many of its children joints hang.
struct Rows {
  std::vector<NodeIndex> below;
  std::vector<int> count;

  Rows(const Scene& scene, const std::vector<NodeIndex>& order, const std::vector<bool>& isJoint)
      : below(isJoint.size()), count(isJoint.size(), 0) {
    for (auto lowest = order.rbegin(); lowest != order.rend(); ++lowest) {
      NodeIndex& own = below[at(*lowest)];
      own = isJoint[at(*lowest)] ? *lowest : own;
      if (const NodeIndex parent = scene.nodes[at(*lowest)].parent; parent.exists() && own.exists()) {
        below[at(parent)] = own;
        ++count[at(parent)];
      }
    }
  }
};

// Whether rows of joints begin all about a node, as they do about hips and not about a whole character's
// node.
bool isAmid(const Scene& scene, const BindPose& bindPose, const Rows& rows, NodeIndex node, double reach) {
  constexpr double about = 0.35;     // of how far the joints reach
  constexpr double samePlace = 1e-3; // a group's node, which tells nothing
  const auto away = [&](NodeIndex other) {
    return glm::distance(positionOf(bindPose.worlds[at(node)]), positionOf(bindPose.worlds[at(other)]));
  };
  return rows.count[at(node)] > 1 &&
         std::ranges::all_of(scene.nodes[at(node)].children, [&](NodeIndex child) {
           const NodeIndex first = rows.below[at(child)];
           return !first.exists() || away(away(child) > samePlace * reach ? child : first) < about * reach;
         });
}

bool isCalledDeforming(const Node& node) {
  return node.name.starts_with("DEF-");
}

std::vector<bool> jointNodes(const Scene& scene, const BindPose& bindPose) {
  constexpr double samePlace = 0.02; // of the way from the joint above to the one below
  std::vector<bool> isJoint(scene.nodes.size(), false);
  Bounds bounds;
  for (const NodeIndex joint : skinJoints(scene)) {
    if (joint.exists() && at(joint) < isJoint.size()) {
      isJoint[at(joint)] = true;
      bounds.add(positionOf(bindPose.worlds[at(joint)]));
    }
  }
  const std::vector<NodeIndex> order = parentsFirst(scene);
  const Rows rows(scene, order, isJoint);
  const auto placeOf = [&](NodeIndex node) { return positionOf(bindPose.worlds[at(node)]); };
  std::vector<NodeIndex> above(isJoint.size()); // nearest joint above each
  for (const NodeIndex node : order) {
    const std::size_t i = at(node);
    const NodeIndex parent = scene.nodes[i].parent;
    above[i] = !parent.exists() || isJoint[at(parent)] ? parent : above[at(parent)];
    const Vec3 place = placeOf(node);
    if (isJoint[i] || rows.count[i] == 0 || scene.nodes[i].mesh >= 0 || !isFinite(place)) {
      continue;
    }
    const Vec3 next = placeOf(rows.below[i]);
    if (above[i].exists()) {
      const Vec3 last = placeOf(above[i]);
      isJoint[i] = std::min(glm::distance(place, last), glm::distance(place, next)) >
                   samePlace * glm::distance(last, next);
    } else {
      isJoint[i] = isAmid(scene, bindPose, rows, node, bounds.largestExtent());
    }
  }
  return isJoint;
}

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

bool hasDeformJoints(const Scene& scene) {
  const std::set<NodeIndex> joints = skinJoints(scene);
  return std::ranges::any_of(joints,
                             [&](NodeIndex joint) { return isCalledDeforming(scene.nodes[at(joint)]); });
}

std::vector<bool> possibleNodes(const Scene& scene, const BindPose& bindPose, Candidates candidates,
                                const std::vector<std::vector<Vec3>>& clouds) {
  std::vector<bool> possible =
      isOfSkins(candidates) ? jointNodes(scene, bindPose) : std::vector<bool>(scene.nodes.size(), true);
  for (std::size_t i = 0; i < possible.size(); ++i) {
    const Node& node = scene.nodes[i];
    // The mesh itself stands for no bone, unless it says so: on a joint of a skin it changes nothing.
    const bool carriesSkin = node.mesh >= 0 && node.skin >= 0 && !isOfSkins(candidates);
    const bool carriesMesh = node.mesh >= 0 && candidates == Candidates::nodesNoMeshes;
    const bool isHandle =
        candidates == Candidates::deformJoints && clouds[i].empty() && !isCalledDeforming(node);
    possible[i] =
        possible[i] && !carriesSkin && !carriesMesh && !isHandle && isFinite(positionOf(bindPose.worlds[i]));
  }
  return possible;
}

} // namespace stretch::rig::body

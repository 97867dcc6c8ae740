#include "rig/body/evidence/joint_nodes.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/finite.h"

namespace stretch::rig::body {

namespace {

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

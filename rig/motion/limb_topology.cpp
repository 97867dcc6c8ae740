#include "rig/motion/limb_topology.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

namespace {

// Nodes from below `ancestor` down to `node`; empty when `node` is not below it.
std::vector<NodeIndex> pathDown(const Scene& scene, NodeIndex ancestor, NodeIndex node) {
  std::vector<NodeIndex> path;
  for (NodeIndex current = node; current != ancestor; current = scene.nodes[at(current)].parent) {
    if (!current.exists()) {
      return {};
    }
    path.push_back(current);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

bool contains(const std::vector<NodeIndex>& nodes, NodeIndex node) {
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

bool subtreeHolds(const Scene& scene, NodeIndex root, const std::set<NodeIndex>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](NodeIndex node) { return isAncestorOrSelf(scene, root, node); });
}

// Joints of all limbs other than `limb`, ends included: what is theirs is no twist joint of ours.
std::set<NodeIndex> jointsOfOthers(const Limb& limb, const std::vector<Limb>& others) {
  std::set<NodeIndex> joints;
  for (const Limb& other : others) {
    if (other.id != limb.id) {
      joints.insert(other.joints.begin(), other.joints.end());
      joints.insert(other.endNode);
    }
  }
  joints.erase(NodeIndex::none);
  for (const NodeIndex own : limb.joints) {
    joints.erase(own);
  }
  joints.erase(limb.endNode);
  return joints;
}

struct BoneLine {
  Vec3 start{0.0};
  Vec3 end{0.0};

  [[nodiscard]] double length() const { return glm::length(end - start); }
  [[nodiscard]] double fraction(const Vec3& p) const {
    const Vec3 axis = end - start;
    const double squared = glm::dot(axis, axis);
    return squared > 0.0 ? glm::dot(p - start, axis) / squared : 0.0;
  }
  [[nodiscard]] double distance(const Vec3& p) const {
    return glm::length(p - (start + (end - start) * fraction(p)));
  }
};

// A twist, roll or split joint lies along the bone, off its ends' neighbours and close to its line.
bool liesAlong(const BoneLine& bone, const Vec3& point) {
  constexpr double slack = 0.02;
  constexpr double nearness = 0.12;
  const double fraction = bone.fraction(point);
  return fraction > -slack && fraction < 1.0 - slack && bone.distance(point) < nearness * bone.length();
}

void collectTwists(const Scene& scene, NodeIndex node, const BoneLine& bone,
                   const std::vector<Mat4>& bindWorlds, const std::set<NodeIndex>& skinned,
                   const std::set<NodeIndex>& othersJoints, std::vector<NodeIndex>& twists) {
  if (skinned.count(node) == 0 || subtreeHolds(scene, node, othersJoints) ||
      !liesAlong(bone, positionOf(bindWorlds[at(node)]))) {
    return;
  }
  twists.push_back(node);
  for (const NodeIndex child : scene.nodes[at(node)].children) {
    collectTwists(scene, child, bone, bindWorlds, skinned, othersJoints, twists);
  }
}

std::set<NodeIndex> legJoints(const std::vector<Limb>& limbs) {
  std::set<NodeIndex> joints;
  for (const Limb& limb : limbs) {
    if (isLeg(limb)) {
      joints.insert(limb.joints.begin(), limb.joints.end());
    }
  }
  return joints;
}

} // namespace

LimbTopology limbTopology(const Scene& scene, const Limb& limb, const std::vector<Limb>& others,
                          const std::vector<Mat4>& bindWorlds) {
  LimbTopology topology;
  const std::set<NodeIndex> skinned = skinJoints(scene);
  const std::set<NodeIndex> othersJoints = jointsOfOthers(limb, others);
  const std::set<NodeIndex> legs = isLeg(limb) ? std::set<NodeIndex>{} : legJoints(others);
  const std::vector<Vec3> points = limbPoints(limb, bindWorlds);
  topology.endIsDescendant =
      !limb.endNode.exists() || isAncestorOrSelf(scene, limb.joints.back(), limb.endNode);
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    BoneTopology bone;
    bone.joint = limb.joints[i];
    const NodeIndex next = i + 1 < limb.joints.size() ? limb.joints[i + 1] : limb.endNode;
    if (next.exists()) {
      bone.pathNodes = pathDown(scene, bone.joint, next);
    }
    const BoneLine line{points[i], points[i + 1]};
    for (const NodeIndex child : scene.nodes[at(bone.joint)].children) {
      const bool onPath = contains(bone.pathNodes, child);
      if (!onPath && i == 0 && subtreeHolds(scene, child, legs)) {
        topology.staying.push_back(child);
        continue;
      }
      if (!onPath) {
        bone.hanging.push_back(child);
        collectTwists(scene, child, line, bindWorlds, skinned, othersJoints, bone.twistNodes);
      }
    }
    // Nodes between two limb joints that deform the mesh (split limbs) and what lies along the bone below
    // them.
    for (std::size_t k = 0; k + 1 < bone.pathNodes.size(); ++k) {
      const NodeIndex node = bone.pathNodes[k];
      if (skinned.count(node) != 0) {
        bone.twistNodes.push_back(node);
      }
    }
    topology.bones.push_back(std::move(bone));
  }
  return topology;
}

std::vector<NodeIndex> touchedNodes(const Limb& limb, const LimbTopology& topology) {
  std::set<NodeIndex> nodes(limb.joints.begin(), limb.joints.end());
  for (const BoneTopology& bone : topology.bones) {
    nodes.insert(bone.pathNodes.begin(), bone.pathNodes.end());
    nodes.insert(bone.hanging.begin(), bone.hanging.end());
    nodes.insert(bone.twistNodes.begin(), bone.twistNodes.end());
  }
  nodes.insert(topology.staying.begin(), topology.staying.end());
  if (limb.endNode.exists()) {
    nodes.insert(limb.endNode);
  }
  return {nodes.begin(), nodes.end()};
}

} // namespace stretch::rig

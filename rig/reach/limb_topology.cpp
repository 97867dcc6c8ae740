#include "rig/reach/limb_topology.h"

#include <algorithm>
#include <set>

#include "core/base/index.h"
#include "rig/limb.h"
#include "rig/reach/limb_riders.h"

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
  return std::ranges::any_of(nodes, [&](NodeIndex node) { return isAncestorOrSelf(scene, root, node); });
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

NodeIndex leaderOf(const Scene& scene, const Limb& limb) {
  if (!limb.ledByFirst || limb.joints.size() < 2) {
    return NodeIndex::none;
  }
  return commonAncestor(scene, limb.joints.front(), limb.joints[1]);
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
                          const BindPlaces& places) {
  LimbTopology topology;
  topology.leader = leaderOf(scene, limb);
  const Riders riders(scene, limb, places, jointsOfOthers(limb, others));
  const std::set<NodeIndex> legs = isLeg(limb) ? std::set<NodeIndex>{} : legJoints(others);
  topology.endIsDescendant =
      !limb.endNode.exists() || isAncestorOrSelf(scene, limb.joints.back(), limb.endNode);
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    BoneTopology bone;
    bone.joint = limb.joints[i];
    const NodeIndex next = i + 1 < limb.joints.size() ? limb.joints[i + 1] : limb.endNode;
    if (next.exists()) {
      bone.pathNodes = pathDown(scene, bone.joint, next);
    }
    for (const NodeIndex child : scene.nodes[at(bone.joint)].children) {
      const bool onPath = contains(bone.pathNodes, child);
      if (!onPath && i == 0 && subtreeHolds(scene, child, legs)) {
        topology.staying.push_back(child);
      } else if (!onPath && i + 1 == limb.joints.size() && riders.isAtEnd(child)) {
        topology.companions.push_back(child);
      } else if (!onPath) {
        bone.hanging.push_back(child);
        riders.collect(child, i, bone.twistNodes);
      }
    }
    riders.collectOnPath(bone.pathNodes, i, bone.twistNodes);
    topology.bones.push_back(std::move(bone));
  }
  const std::vector<NodeIndex> elsewhere = companionsElsewhere(scene, limb, others, places);
  topology.companions.insert(topology.companions.end(), elsewhere.begin(), elsewhere.end());
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
  nodes.insert(topology.companions.begin(), topology.companions.end());
  for (const NodeIndex node : {limb.endNode, topology.leader}) {
    if (node.exists()) {
      nodes.insert(node);
    }
  }
  return {nodes.begin(), nodes.end()};
}

} // namespace stretch::rig

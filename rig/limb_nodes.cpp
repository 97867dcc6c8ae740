#include "rig/limb_nodes.h"

#include <algorithm>

namespace stretch::rig {

namespace {

constexpr int nobody = -1;
constexpr int unknown = -2;

/// Of the nearest node above that has an owner.
int ownerFromAbove(const Scene& scene, NodeIndex node, std::vector<int>& owners) {
  std::vector<NodeIndex> way;
  int owner = nobody;
  for (NodeIndex above = node; above.exists(); above = scene.nodes[at(above)].parent) {
    if (owners[at(above)] != unknown) {
      owner = owners[at(above)];
      break;
    }
    way.push_back(above);
  }
  for (const NodeIndex passed : way) {
    owners[at(passed)] = owner;
  }
  return owner;
}

} // namespace

std::vector<int> limbOfNodes(const Scene& scene, const std::vector<Limb>& limbs, NodeIndex hips) {
  std::vector<int> owners(scene.nodes.size(), unknown);
  const auto give = [&](NodeIndex node, std::size_t limb) {
    if (node.exists() && at(node) < owners.size() && owners[at(node)] == unknown) {
      owners[at(node)] = static_cast<int>(limb);
    }
  };
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    for (const NodeIndex joint : limbs[i].joints) {
      give(joint, i);
    }
  }
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    give(limbs[i].endNode, i);
  }
  const auto trunk =
      std::find_if(limbs.begin(), limbs.end(), [](const Limb& limb) { return limb.kind == LimbKind::spine; });
  if (trunk != limbs.end()) {
    give(hips, static_cast<std::size_t>(trunk - limbs.begin()));
  }
  for (std::size_t i = 0; i < owners.size(); ++i) {
    owners[i] = ownerFromAbove(scene, NodeIndex(i), owners);
  }
  return owners;
}

bool isAtEnd(const Scene& scene, const Limb& limb, NodeIndex node) {
  return limb.endNode.exists() && node.exists() && isAncestorOrSelf(scene, limb.endNode, node);
}

} // namespace stretch::rig

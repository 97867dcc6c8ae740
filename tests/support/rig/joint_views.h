#pragma once

#include "rig/body/evidence/body_view.h"

namespace stretch::test {

/// Adds a joint of the node to a view, without a name or a mesh, below one that is in it (-1: below none);
/// answers its number.
inline int addJoint(rig::body::BodyView& view, NodeIndex node, int parent, const Vec3& positionWorld) {
  const auto above = static_cast<std::size_t>(parent);
  const int joint = view.count();
  view.nodes.push_back(node);
  view.candidateOfNode.push_back(joint);
  view.parent.push_back(parent);
  view.isDetached.push_back(false);
  view.children.emplace_back();
  view.depth.push_back(parent < 0 ? 0 : view.depth[above] + 1);
  view.position.push_back(positionWorld);
  view.called.emplace_back();
  view.names.emplace_back();
  view.points.emplace_back();
  view.tips.emplace_back();
  view.verticesBelow.push_back(0);
  view.reach.push_back(0.0);
  if (parent >= 0) {
    view.children[above].push_back(joint);
  }
  return joint;
}

} // namespace stretch::test

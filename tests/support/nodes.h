#pragma once

#include <string>

#include "core/scene/scene.h"

namespace stretch::test {

/// Appends a node below `parent` (none: a root) with a rest translation; answers its index.
inline NodeIndex addNode(Scene& scene, const std::string& name, NodeIndex parent, const Vec3& translation) {
  const NodeIndex index(scene.nodes.size());
  Node node;
  node.name = name;
  node.parent = parent;
  node.rest.translation = translation;
  scene.nodes.push_back(node);
  if (parent.exists()) {
    scene.nodes[at(parent)].children.push_back(index);
  } else {
    scene.roots.push_back(index);
  }
  return index;
}

} // namespace stretch::test

#pragma once

#include <string>

#include "core/scene/scene.h"

namespace stretch::test {

/// Appends a node below `parent` (-1: a root) with a rest translation; answers its index.
inline int addNode(Scene& scene, const std::string& name, int parent, const Vec3& translation) {
  const auto index = static_cast<int>(scene.nodes.size());
  Node node;
  node.name = name;
  node.parent = parent;
  node.rest.translation = translation;
  scene.nodes.push_back(node);
  if (parent >= 0) {
    scene.nodes[static_cast<std::size_t>(parent)].children.push_back(index);
  } else {
    scene.roots.push_back(index);
  }
  return index;
}

} // namespace stretch::test

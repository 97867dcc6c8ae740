#include "core/scene/scene.h"

namespace stretch {

std::vector<int> parentsFirst(const Scene& scene) {
  std::vector<int> order;
  order.reserve(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].parent < 0) {
      order.push_back(static_cast<int>(i));
    }
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const Node& node = scene.nodes[static_cast<std::size_t>(order[next])];
    order.insert(order.end(), node.children.begin(), node.children.end());
  }
  return order;
}

bool isAncestorOrSelf(const Scene& scene, int ancestor, int node) {
  while (node >= 0 && node != ancestor) {
    node = scene.nodes[static_cast<std::size_t>(node)].parent;
  }
  return node == ancestor;
}

} // namespace stretch

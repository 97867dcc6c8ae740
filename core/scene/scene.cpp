#include "core/scene/scene.h"

namespace stretch {

std::vector<NodeIndex> parentsFirst(const Scene& scene) {
  std::vector<NodeIndex> order;
  order.reserve(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!scene.nodes[i].parent.exists()) {
      order.emplace_back(i);
    }
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const Node& node = scene.nodes[at(order[next])];
    order.insert(order.end(), node.children.begin(), node.children.end());
  }
  return order;
}

bool isAncestorOrSelf(const Scene& scene, NodeIndex ancestor, NodeIndex node) {
  while (node.exists() && node != ancestor) {
    node = scene.nodes[at(node)].parent;
  }
  return node == ancestor;
}

NodeIndex commonAncestor(const Scene& scene, NodeIndex a, NodeIndex b) {
  while (a.exists() && !isAncestorOrSelf(scene, a, b)) {
    a = scene.nodes[at(a)].parent;
  }
  return a;
}

NodeIndex humanoidNode(const Scene& scene, const std::string& bone) {
  const auto found = scene.humanoid.find(bone);
  const bool isThere =
      found != scene.humanoid.end() && found->second.exists() && at(found->second) < scene.nodes.size();
  return isThere ? found->second : NodeIndex::none;
}

std::vector<NodeIndex> withSubtrees(const Scene& scene, const std::vector<NodeIndex>& nodes) {
  std::vector<bool> wanted(scene.nodes.size(), false);
  for (const NodeIndex node : nodes) {
    wanted[at(node)] = true;
  }
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    wanted[at(node)] = wanted[at(node)] || (parent.exists() && wanted[at(parent)]);
  }
  std::vector<NodeIndex> all;
  for (std::size_t node = 0; node < wanted.size(); ++node) {
    if (wanted[node]) {
      all.emplace_back(node);
    }
  }
  return all;
}

const SceneCamera* cameraNamed(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                  [&](const SceneCamera& camera) { return camera.name == name; });
  return found != scene.cameras.end() ? &*found : nullptr;
}

std::set<NodeIndex> skinJoints(const Scene& scene) {
  std::set<NodeIndex> joints;
  for (const Skin& skin : scene.skins) {
    joints.insert(skin.joints.begin(), skin.joints.end());
  }
  return joints;
}

std::size_t vertexCount(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      count += primitive.positions.size();
    }
  }
  return count;
}

} // namespace stretch

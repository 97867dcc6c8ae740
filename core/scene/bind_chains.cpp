#include "core/scene/bind_chains.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace stretch {

namespace {

Node& nodeOf(Scene& scene, NodeIndex node) {
  return scene.nodes[at(node)];
}

bool isLeafAsWritten(const Node& node) {
  return node.isBindLeaf && !node.matrix && glm::length(node.rest.translation) <= 0.0;
}

std::optional<BindChain> chainAt(Scene& scene, NodeIndex leaf) {
  const Node& node = nodeOf(scene, leaf);
  if (!isLeafAsWritten(node) || !node.parent.exists() || nodeOf(scene, node.parent).isBindLeaf ||
      node.children.size() > 1) {
    return std::nullopt;
  }
  BindChain chain{node.parent, leaf, NodeIndex::none, node.rest.rotation};
  if (!node.children.empty()) {
    chain.endLeaf = node.children.front();
    const Node& end = nodeOf(scene, chain.endLeaf);
    if (!isLeafAsWritten(end) || !end.children.empty()) {
      return std::nullopt;
    }
    chain.restTurn = node.rest.rotation * end.rest.rotation;
  }
  return chain;
}

bool hasMorphTargets(const Scene& scene, int mesh) {
  const std::vector<Primitive>& primitives = scene.meshes[static_cast<std::size_t>(mesh)].primitives;
  return std::ranges::any_of(primitives,
                             [](const Primitive& primitive) { return !primitive.morphTargets.empty(); });
}

// A clip moves the morph weights of the node that holds the mesh: then it has to stay where it is.
bool canFold(Scene& scene, const BindChain& chain) {
  const Node& last = nodeOf(scene, chain.lastLeaf());
  const Node& joint = nodeOf(scene, chain.joint);
  return last.mesh < 0 || (last.skin < 0 && joint.mesh < 0 && !hasMorphTargets(scene, last.mesh));
}

void fold(Scene& scene, const BindChain& chain) {
  const Mat4 atRest = glm::mat4_cast(chain.restTurn);
  for (Skin& skin : scene.skins) {
    for (std::size_t slot = 0; slot < skin.joints.size(); ++slot) {
      if (skin.joints[slot] == chain.lastLeaf()) {
        skin.joints[slot] = chain.joint;
        skin.inverseBind[slot] = atRest * skin.inverseBind[slot];
      }
    }
  }
  std::swap(nodeOf(scene, chain.joint).mesh, nodeOf(scene, chain.lastLeaf()).mesh);
  scene.bindChains.push_back(chain);
}

bool isNamed(const Primitive& primitive, std::size_t slot) {
  return std::ranges::any_of(primitive.influences, [&](const VertexInfluences& vertex) {
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      if (vertex.weights[i] != 0.0F && vertex.joints[i] == slot) {
        return true;
      }
    }
    return false;
  });
}

// Whether a vertex of a mesh that the skin moves hangs on the slot.
bool isNamed(const Scene& scene, int skin, std::size_t slot) {
  return std::ranges::any_of(scene.nodes, [&](const Node& node) {
    return node.skin == skin && node.mesh >= 0 &&
           std::ranges::any_of(scene.meshes[at(node.mesh)].primitives,
                               [&](const Primitive& primitive) { return isNamed(primitive, slot); });
  });
}

// Joints whose slots their leaves took stand once more at the end of the list, where no vertex names them
// (docs/file-format.md, Bind leaves).
void dropRepeatedJoints(Scene& scene, int skinIndex) {
  Skin& skin = scene.skins[at(skinIndex)];
  while (!skin.joints.empty() && findBindChain(scene, skin.joints.back()) != nullptr &&
         std::find(skin.joints.begin(), skin.joints.end() - 1, skin.joints.back()) != skin.joints.end() - 1 &&
         !isNamed(scene, skinIndex, skin.joints.size() - 1)) {
    skin.joints.pop_back();
    skin.inverseBind.pop_back();
  }
}

} // namespace

void foldBindLeaves(Scene& scene) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const std::optional<BindChain> chain = chainAt(scene, NodeIndex(i));
    if (chain && canFold(scene, *chain) && findBindChain(scene, chain->joint) == nullptr) {
      fold(scene, *chain);
    }
  }
  for (std::size_t skin = 0; skin < scene.skins.size(); ++skin) {
    dropRepeatedJoints(scene, static_cast<int>(skin));
  }
}

const BindChain* findBindChain(const Scene& scene, NodeIndex joint) {
  const auto found =
      std::ranges::find_if(scene.bindChains, [&](const BindChain& chain) { return chain.joint == joint; });
  return found == scene.bindChains.end() ? nullptr : &*found;
}

} // namespace stretch

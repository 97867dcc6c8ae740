#include "core/scene/bind_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
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
  return node.isBindLeaf && !node.isBindCorner && !node.matrix && glm::length(node.rest.translation) <= 0.0;
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

bool isCornerOfChain(const Scene& scene, NodeIndex node) {
  const BindChain* const chain =
      scene.nodes[at(node)].isBindCorner ? findBindChain(scene, scene.nodes[at(node)].parent) : nullptr;
  return chain != nullptr &&
         std::ranges::find(chain->corners, node, &BindCorner::node) != chain->corners.end();
}

// Joints whose slots their leaves took stand once more at the end of the list, where no vertex names them
// (docs/file-format.md, Bind leaves), and so do corners.
void dropOwnJoints(Scene& scene, int skinIndex) {
  Skin& skin = scene.skins[at(skinIndex)];
  const auto isOwn = [&](NodeIndex last) {
    const bool isRepeated =
        findBindChain(scene, last) != nullptr &&
        std::find(skin.joints.begin(), skin.joints.end() - 1, last) != skin.joints.end() - 1;
    return isRepeated || isCornerOfChain(scene, last);
  };
  while (!skin.joints.empty() && isOwn(skin.joints.back()) &&
         !isNamed(scene, skinIndex, skin.joints.size() - 1)) {
    skin.joints.pop_back();
    skin.inverseBind.pop_back();
  }
}

bool isCornerAsWritten(const Scene& scene, const Node& node) {
  const Transform place{node.rest.translation, Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)};
  return node.isBindCorner && !node.matrix && node.children.empty() && node.mesh < 0 && node.rest == place &&
         node.parent.exists() && !scene.nodes[at(node.parent)].isBindLeaf;
}

// Whether a corner moves a mesh at rest as its joint does.
bool standsByJoint(const Skin& skin, std::size_t corner, std::size_t joint, const Vec3& place) {
  constexpr double rounding = 1e-5; // of single precision
  const Mat4& own = skin.inverseBind[corner];
  const Mat4& ofJoint = skin.inverseBind[joint];
  double miss = glm::length(Vec3(own[3]) + place - Vec3(ofJoint[3]));
  double size = glm::length(place) + glm::length(Vec3(ofJoint[3]));
  for (int column = 0; column < 3; ++column) {
    miss = std::max(miss, glm::length(Vec3(own[column]) - Vec3(ofJoint[column])));
    size = std::max(size, glm::length(Vec3(ofJoint[column])));
  }
  return miss <= rounding * size;
}

// Slots of the skins that corners have; nothing where one of them does not stand as it was written.
std::optional<BindCorner> cornerAt(const Scene& scene, NodeIndex node) {
  BindCorner corner{node, scene.nodes[at(node)].rest.translation, {}};
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    const Skin& skin = scene.skins[s];
    const auto slot = std::ranges::find(skin.joints, node) - skin.joints.begin();
    const auto joint = std::ranges::find(skin.joints, scene.nodes[at(node)].parent) - skin.joints.begin();
    const auto count = static_cast<std::ptrdiff_t>(skin.joints.size());
    if (slot == count) {
      continue;
    }
    if (joint == count ||
        !standsByJoint(skin, static_cast<std::size_t>(slot), static_cast<std::size_t>(joint), corner.place)) {
      return std::nullopt;
    }
    corner.slotOf[static_cast<int>(s)] = static_cast<int>(slot);
  }
  return corner.slotOf.empty() ? std::nullopt : std::optional(std::move(corner));
}

// The chains of corners that stand as they were written, all of a joint.
std::vector<BindChain> cornerChains(const Scene& scene) {
  std::map<NodeIndex, BindChain> chains;
  std::set<NodeIndex> changed;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.isBindCorner) {
      continue;
    }
    std::optional<BindCorner> corner =
        isCornerAsWritten(scene, node) ? cornerAt(scene, NodeIndex(i)) : std::nullopt;
    if (!corner) {
      changed.insert(node.parent);
      continue;
    }
    BindChain& chain = chains[node.parent];
    chain.joint = node.parent;
    chain.corners.push_back(std::move(*corner));
  }
  std::vector<BindChain> sound;
  for (auto& [joint, chain] : chains) {
    if (!changed.contains(joint) && findBindChain(scene, joint) == nullptr) {
      sound.push_back(std::move(chain));
    }
  }
  return sound;
}

// A mesh that two skins move cannot follow the joints of both in the place of their corners.
bool isMovedByOneSkin(const Scene& scene, int mesh) {
  std::set<int> skins;
  for (const Node& node : scene.nodes) {
    if (node.mesh == mesh) {
      skins.insert(node.skin);
    }
  }
  return skins.size() == 1;
}

// Answers whether the vertex follows a corner.
bool follow(const std::map<std::uint16_t, std::uint16_t>& jointOfCorner, VertexInfluences& vertex) {
  bool isOnCorners = false;
  for (std::uint16_t& slot : vertex.joints) {
    const auto joint = jointOfCorner.find(slot);
    isOnCorners = isOnCorners || joint != jointOfCorner.end();
    slot = joint == jointOfCorner.end() ? slot : joint->second;
  }
  vertex = withoutRepeats(vertex);
  return isOnCorners;
}

void foldCorners(Scene& scene) {
  std::map<int, std::map<std::uint16_t, std::uint16_t>> jointOfCorner; // slots, by skin
  for (BindChain& chain : cornerChains(scene)) {
    for (const BindCorner& corner : chain.corners) {
      for (const auto& [skin, slot] : corner.slotOf) {
        const std::vector<NodeIndex>& joints = scene.skins[at(skin)].joints;
        jointOfCorner[skin][static_cast<std::uint16_t>(slot)] =
            static_cast<std::uint16_t>(std::ranges::find(joints, chain.joint) - joints.begin());
      }
    }
    scene.bindChains.push_back(std::move(chain));
  }
  std::set<int> done;
  for (const Node& node : scene.nodes) {
    const auto slots = jointOfCorner.find(node.skin);
    if (node.mesh < 0 || slots == jointOfCorner.end() || !done.insert(node.mesh).second) {
      continue;
    }
    for (Primitive& primitive : scene.meshes[at(node.mesh)].primitives) {
      std::vector<VertexInfluences> asWritten = primitive.influences;
      bool isOnCorners = false;
      for (VertexInfluences& vertex : primitive.influences) {
        isOnCorners = follow(slots->second, vertex) || isOnCorners;
      }
      primitive.onCorners = isOnCorners ? std::move(asWritten) : std::vector<VertexInfluences>();
    }
  }
}

bool cornersCanFold(const Scene& scene) {
  return std::ranges::any_of(scene.nodes, &Node::isBindCorner) &&
         std::ranges::all_of(scene.nodes, [&](const Node& node) {
           return node.mesh < 0 || node.skin < 0 || isMovedByOneSkin(scene, node.mesh);
         });
}

} // namespace

void foldBindLeaves(Scene& scene) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const std::optional<BindChain> chain = chainAt(scene, NodeIndex(i));
    if (chain && canFold(scene, *chain) && findBindChain(scene, chain->joint) == nullptr) {
      fold(scene, *chain);
    }
  }
  if (cornersCanFold(scene)) {
    foldCorners(scene);
  }
  for (std::size_t skin = 0; skin < scene.skins.size(); ++skin) {
    dropOwnJoints(scene, static_cast<int>(skin));
  }
}

std::vector<NodeIndex> BindChain::nodes() const {
  std::vector<NodeIndex> all;
  std::ranges::copy_if(std::array{leaf, endLeaf}, std::back_inserter(all), &NodeIndex::exists);
  std::ranges::transform(corners, std::back_inserter(all), &BindCorner::node);
  return all;
}

VertexInfluences withoutRepeats(const VertexInfluences& vertex) {
  VertexInfluences once;
  std::size_t count = 0;
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    auto* const end = once.joints.begin() + static_cast<std::ptrdiff_t>(count);
    const auto known =
        static_cast<std::size_t>(std::find(once.joints.begin(), end, vertex.joints[i]) - once.joints.begin());
    if (vertex.weights[i] > 0.0F) {
      once.joints[known] = vertex.joints[i];
      once.weights[known] += vertex.weights[i];
      count = std::max(count, known + 1);
    }
  }
  return once;
}

const BindChain* findBindChain(const Scene& scene, NodeIndex joint) {
  const auto found =
      std::ranges::find_if(scene.bindChains, [&](const BindChain& chain) { return chain.joint == joint; });
  return found == scene.bindChains.end() ? nullptr : &*found;
}

} // namespace stretch

#include "core/gltf/patch/added_skeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/anim/frame_state.h"
#include "core/gltf/json/json.h"

namespace stretch::gltf {

namespace {

std::vector<Mat4> restWorlds(const Scene& scene) {
  return frameOf(scene, restPose(scene), 0.0).worlds;
}

// Turns, moves and scales alike in all directions, and mirrors nothing.
bool isSimilarity(const Mat4& matrix) {
  const Vec3 x(matrix[0]);
  const Vec3 y(matrix[1]);
  const Vec3 z(matrix[2]);
  const double size = glm::length(x);
  constexpr double tolerance = 1e-4;
  const double room = tolerance * size * size;
  return size > 0.0 && std::isfinite(size) && std::abs(glm::dot(x, y)) < room &&
         std::abs(glm::dot(y, z)) < room && std::abs(glm::dot(z, x)) < room &&
         std::abs(glm::dot(y, y) - size * size) < room && std::abs(glm::dot(z, z) - size * size) < room &&
         glm::dot(glm::cross(x, y), z) > 0.0;
}

bool isAboveAll(const Scene& scene, NodeIndex node, const std::vector<NodeIndex>& meshNodes) {
  return std::ranges::all_of(
      meshNodes, [&](NodeIndex mesh) { return mesh != node && isAncestorOrSelf(scene, node, mesh); });
}

Mat4 worldOf(const Scene& scene, NodeIndex carrier) {
  return carrier.exists() ? restWorlds(scene)[at(carrier)] : Mat4(1.0);
}

// References to nodes from `firstNode` on; a list that is left empty goes as well.
void takeOutReferences(std::size_t firstNode, Json& holder, const char* key) {
  if (!holder.contains(key)) {
    return;
  }
  Json kept = Json::array();
  for (const Json& node : holder[key]) {
    if (node.get<std::size_t>() < firstNode) {
      kept.push_back(node);
    }
  }
  if (kept.empty()) {
    holder.erase(key);
  } else {
    holder[key] = std::move(kept);
  }
}

} // namespace

NodeIndex carrierOfSkeleton(const Scene& scene, const std::vector<NodeIndex>& meshNodes) {
  if (meshNodes.empty()) {
    return NodeIndex::none;
  }
  const std::vector<Mat4> worlds = restWorlds(scene);
  NodeIndex carrier = scene.nodes[at(meshNodes.front())].parent;
  while (carrier.exists() && !(isAboveAll(scene, carrier, meshNodes) && isSimilarity(worlds[at(carrier)]))) {
    carrier = scene.nodes[at(carrier)].parent;
  }
  return carrier;
}

std::vector<Mat4> skeletonWorlds(const Scene& scene, const std::vector<SkeletonJoint>& joints,
                                 NodeIndex carrier) {
  const Vec3 scale(glm::length(Vec3(worldOf(scene, carrier)[0])));
  std::vector<Mat4> worlds;
  worlds.reserve(joints.size());
  for (const SkeletonJoint& joint : joints) {
    worlds.push_back(toMatrix({joint.place, glm::normalize(joint.orientation), scale}));
  }
  return worlds;
}

std::vector<AddedNode> skeletonNodes(const Scene& scene, const std::vector<SkeletonJoint>& joints,
                                     NodeIndex carrier) {
  const Mat4 carrierWorld = worldOf(scene, carrier);
  const std::vector<Mat4> worlds = skeletonWorlds(scene, joints, carrier);
  std::vector<AddedNode> nodes;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool hasParent = joints[i].parent >= 0;
    const Mat4& above = hasParent ? worlds[stretch::at(joints[i].parent)] : carrierWorld;
    AddedNode node;
    node.name = joints[i].name;
    node.parent = hasParent ? NodeIndex(scene.nodes.size() + stretch::at(joints[i].parent)) : carrier;
    node.rest = toTransform(glm::inverse(above) * worlds[i]);
    node.rest.scale = Vec3(1.0);
    node.isBindLeaf = false;
    nodes.push_back(std::move(node));
  }
  return nodes;
}

void takeOutSkeleton(std::size_t firstNode, Json& json) {
  auto& nodes = json.at("nodes").get_ref<Json::array_t&>();
  nodes.resize(std::min(firstNode, nodes.size()));
  for (Json& node : nodes) {
    takeOutReferences(firstNode, node, "children");
  }
  if (json.contains("scenes")) {
    for (Json& scene : json["scenes"]) {
      takeOutReferences(firstNode, scene, "nodes");
    }
  }
  auto& skins = json.at("skins").get_ref<Json::array_t&>();
  skins.pop_back();
  if (skins.empty()) {
    json.erase("skins");
  }
}

} // namespace stretch::gltf

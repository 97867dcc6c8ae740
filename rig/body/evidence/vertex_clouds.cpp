#include <algorithm>

#include "core/math/finite.h"

#include "core/scene/morphs.h"
#include "rig/body/evidence/body_view.h"

namespace stretch::rig::body {

namespace {

NodeIndex strongestJoint(const VertexInfluences& influences, const Skin& skin) {
  const auto* const strongest = std::ranges::max_element(influences.weights);
  if (!(*strongest > 0.0F)) {
    return NodeIndex::none;
  }
  const auto slot = static_cast<std::size_t>(strongest - influences.weights.begin());
  const std::size_t joint = influences.joints[slot];
  return joint < skin.joints.size() ? skin.joints[joint] : NodeIndex::none;
}

void addPoint(std::vector<std::vector<Vec3>>& clouds, NodeIndex node, const Mat4& placement,
              const Vec3& position) {
  const Vec3 world = transformPoint(placement, position);
  if (node.exists() && at(node) < clouds.size() && isFinite(world)) {
    clouds[at(node)].push_back(world);
  }
}

// Vertices stand where the morph weights at rest put them.
Vec3 placeOf(const Scene& scene, const Node& holder, const Primitive& primitive, std::size_t vertex) {
  return morphedPlace(scene.meshes[static_cast<std::size_t>(holder.mesh)], primitive, holder.morphWeights,
                      vertex);
}

void addSkinned(std::vector<std::vector<Vec3>>& clouds, const Scene& scene, const BindPose& bindPose,
                const Node& holder, const Primitive& primitive) {
  const auto index = static_cast<std::size_t>(holder.skin);
  const std::size_t count = std::min(primitive.positions.size(), primitive.influences.size());
  for (std::size_t i = 0; i < count; ++i) {
    const NodeIndex joint = strongestJoint(primitive.influences[i], scene.skins[index]);
    const bool isAtRest = bindPose.areAtRest[index] && joint.exists();
    addPoint(clouds, joint, isAtRest ? bindPose.worlds[at(joint)] : bindPose.placements[index],
             placeOf(scene, holder, primitive, i));
  }
}

void addRigid(std::vector<std::vector<Vec3>>& clouds, const Scene& scene, NodeIndex node,
              const Primitive& primitive, const Mat4& world) {
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    addPoint(clouds, node, world, placeOf(scene, scene.nodes[at(node)], primitive, i));
  }
}

bool isIndex(int index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

} // namespace

namespace {

void addSkinnedMeshes(const Scene& scene, const BindPose& bindPose, std::vector<std::vector<Vec3>>& clouds) {
  for (const Node& node : scene.nodes) {
    if (!isIndex(node.mesh, scene.meshes.size()) || !isIndex(node.skin, scene.skins.size())) {
      continue;
    }
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (!primitive.influences.empty()) {
        addSkinned(clouds, scene, bindPose, node, primitive);
      }
    }
  }
}

// For each node the joint that it is, else the nearest one above it; none where there is none.
std::vector<NodeIndex> jointsAtOrAbove(const Scene& scene) {
  const std::set<NodeIndex> joints = skinJoints(scene);
  std::vector<NodeIndex> above(scene.nodes.size());
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    above[at(node)] = joints.count(node) != 0 ? node : parent.exists() ? above[at(parent)] : NodeIndex::none;
  }
  return above;
}

// Rigid meshes of the body in a scene with skins: on at least two joints in a row that move no vertices. One
// alone is the slot of a prop.
std::vector<bool> bodyParts(const Scene& scene, const std::vector<std::vector<Vec3>>& skinned) {
  const std::vector<NodeIndex> nearest = jointsAtOrAbove(scene);
  std::vector<NodeIndex> jointOf(scene.nodes.size());
  std::set<NodeIndex> carriers;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const NodeIndex joint = nearest[node];
    if (scene.nodes[node].mesh >= 0 && scene.nodes[node].skin < 0 && joint.exists() &&
        skinned[at(joint)].empty()) {
      jointOf[node] = joint;
      carriers.insert(joint);
    }
  }
  std::set<NodeIndex> inRow;
  for (const NodeIndex joint : carriers) {
    const NodeIndex parent = scene.nodes[at(joint)].parent;
    const NodeIndex above = parent.exists() ? nearest[at(parent)] : NodeIndex::none;
    if (above.exists() && carriers.count(above) != 0) {
      inRow.insert({joint, above});
    }
  }
  std::vector<bool> parts;
  parts.reserve(jointOf.size());
  for (const NodeIndex joint : jointOf) {
    parts.push_back(joint.exists() && inRow.count(joint) != 0);
  }
  return parts;
}

} // namespace

std::vector<std::vector<Vec3>> vertexClouds(const Scene& scene, const BindPose& bindPose, RigidMeshes rigid) {
  std::vector<std::vector<Vec3>> clouds(scene.nodes.size());
  addSkinnedMeshes(scene, bindPose, clouds);
  if (rigid == RigidMeshes::none) {
    return clouds;
  }
  const std::vector<bool> parts = rigid == RigidMeshes::bodyParts
                                      ? bodyParts(scene, clouds)
                                      : std::vector<bool>(scene.nodes.size(), true);
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const Node& holder = scene.nodes[node];
    if (!isIndex(holder.mesh, scene.meshes.size()) || !parts[node]) {
      continue;
    }
    const bool isSkinned = isIndex(holder.skin, scene.skins.size());
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(holder.mesh)].primitives) {
      if (!isSkinned || primitive.influences.empty()) {
        addRigid(clouds, scene, NodeIndex(node), primitive, bindPose.worlds[node]);
      }
    }
  }
  return clouds;
}

} // namespace stretch::rig::body

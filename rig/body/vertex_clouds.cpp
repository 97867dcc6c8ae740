#include <algorithm>

#include "core/math/finite.h"

#include "rig/body/body_view.h"

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
              const glm::vec3& position) {
  const Vec3 world = transformPoint(placement, Vec3(position));
  if (node.exists() && at(node) < clouds.size() && isFinite(world)) {
    clouds[at(node)].push_back(world);
  }
}

void addSkinned(std::vector<std::vector<Vec3>>& clouds, const Primitive& primitive, const Skin& skin,
                const Mat4& placement) {
  const std::size_t count = std::min(primitive.positions.size(), primitive.influences.size());
  for (std::size_t i = 0; i < count; ++i) {
    addPoint(clouds, strongestJoint(primitive.influences[i], skin), placement, primitive.positions[i]);
  }
}

void addRigid(std::vector<std::vector<Vec3>>& clouds, const Primitive& primitive, NodeIndex node,
              const Mat4& world) {
  for (const glm::vec3& position : primitive.positions) {
    addPoint(clouds, node, world, position);
  }
}

bool isIndex(int index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

} // namespace

std::vector<std::vector<Vec3>> vertexClouds(const Scene& scene, const BindPose& bindPose, bool rigidMeshes) {
  std::vector<std::vector<Vec3>> clouds(scene.nodes.size());
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const int mesh = scene.nodes[node].mesh;
    const int skin = scene.nodes[node].skin;
    if (!isIndex(mesh, scene.meshes.size())) {
      continue;
    }
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
      if (isIndex(skin, scene.skins.size()) && !primitive.influences.empty()) {
        const auto index = static_cast<std::size_t>(skin);
        addSkinned(clouds, primitive, scene.skins[index], bindPose.placements[index]);
      } else if (rigidMeshes) {
        addRigid(clouds, primitive, NodeIndex(node), bindPose.worlds[node]);
      }
    }
  }
  return clouds;
}

} // namespace stretch::rig::body

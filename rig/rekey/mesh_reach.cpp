#include "rig/rekey/mesh_reach.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

void addSkinned(const Primitive& primitive, const Skin& skin, std::vector<double>& reach) {
  for (std::size_t v = 0; v < primitive.influences.size(); ++v) {
    const Vec3 point(primitive.positions[v]);
    const VertexInfluences& influences = primitive.influences[v];
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      const std::size_t slot = influences.joints[i];
      const auto weight = static_cast<double>(influences.weights[i]);
      if (weight > 0.0 && slot < skin.joints.size()) {
        double& farthest = reach[at(skin.joints[slot])];
        farthest = std::max(farthest, weight * glm::length(transformPoint(skin.inverseBind[slot], point)));
      }
    }
  }
}

void addRigid(const Primitive& primitive, double& farthest) {
  for (const glm::vec3& position : primitive.positions) {
    farthest = std::max(farthest, glm::length(Vec3(position)));
  }
}

} // namespace

std::vector<double> meshReach(const Scene& scene) {
  std::vector<double> reach(scene.nodes.size(), 0.0);
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const int mesh = scene.nodes[node].mesh;
    const int skin = scene.nodes[node].skin;
    if (mesh < 0) {
      continue;
    }
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
      if (skin >= 0 && !primitive.influences.empty()) {
        addSkinned(primitive, scene.skins[static_cast<std::size_t>(skin)], reach);
      } else {
        addRigid(primitive, reach[node]);
      }
    }
  }
  return reach;
}

} // namespace stretch::rig

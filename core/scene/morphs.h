#pragma once

#include <algorithm>

#include "core/scene/scene.h"

namespace stretch {

/// A place or a normal at rest, moved by the morph targets.
[[nodiscard]] inline Vec3 morphed(const Vec3& rest, std::vector<glm::vec3> MorphTarget::*offsets,
                                  const Primitive& primitive, const std::vector<float>& weights,
                                  std::size_t vertex) {
  Vec3 moved = rest;
  const std::size_t targets = std::min(weights.size(), primitive.morphTargets.size());
  for (std::size_t target = 0; target < targets; ++target) {
    const std::vector<glm::vec3>& offset = primitive.morphTargets[target].*offsets;
    if (weights[target] != 0.0F && vertex < offset.size()) {
      moved += static_cast<double>(weights[target]) * Vec3(offset[vertex]);
    }
  }
  return moved;
}

/// A vertex in its mesh's space by the weights of the node that shows the mesh, as the node or a pose has
/// them; where these are none, by the mesh's own.
[[nodiscard]] inline Vec3 morphedPlace(const Mesh& mesh, const Primitive& primitive,
                                       const std::vector<float>& nodeWeights, std::size_t vertex) {
  const std::vector<float>& weights = nodeWeights.empty() ? mesh.morphWeights : nodeWeights;
  return morphed(Vec3(primitive.positions[vertex]), &MorphTarget::positions, primitive, weights, vertex);
}

} // namespace stretch

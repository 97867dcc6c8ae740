#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// A bone as a straight piece in the pose of the mesh.
struct BoneSegment {
  Vec3 start{0.0};
  Vec3 end{0.0};
};

struct GeodesicWeightSettings {
  double power = 4.0;  ///< Sharpens the inverse distance; larger is more rigid.
  double offset = 0.5; ///< Added to a distance, in lengths of the bone: how soft the border between two
                       ///< patches is.
};

/// Skin weights by inverse geodesic distance: every face seeds the patch of the bone segment that is nearest
/// to it; a vertex weighs (distance to the patch over the surface / bone length + offset)^-power, at most 4
/// bones, normalised. Bones without a face of their own get no weight. Parts that no patch reaches follow the
/// bone nearest in space. An error for no bones or no triangles.
[[nodiscard]] Result<std::vector<Influences>> geodesicWeights(std::span<const glm::vec3> positions,
                                                              const std::vector<Triangle>& triangles,
                                                              const std::vector<BoneSegment>& bones,
                                                              const GeodesicWeightSettings& settings = {});

/// Keeps the four largest weights and makes them sum to 1; all zero gives bone 0 the whole weight.
[[nodiscard]] Influences strongestFour(const std::vector<double>& weights);

} // namespace stretch::skinning

#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// A joint that a mesh is to follow, in the space of the mesh.
struct BindJoint {
  Vec3 place{0.0};
  int parent = -1; ///< Index into the joints; -1: none.
};

struct BindSettings {
  int cubesAlong = 110;  ///< Along the longest side of the mesh's box.
  double blend = 0.35;   ///< How far two bones share the mesh about their joint, in radii of the body there.
  double regions = 1.0;  ///< How much a thick bone's section counts against a thin one's: 0 for lines alone.
  double shells = 0.6;
};

/// Skin weights by distance inside the body (docs/binding.md).
[[nodiscard]] Result<std::vector<Influences>> bindWeights(std::span<const glm::vec3> positions,
                                                          const std::vector<Triangle>& triangles,
                                                          const std::vector<BindJoint>& joints,
                                                          const BindSettings& settings = {});

} // namespace stretch::skinning

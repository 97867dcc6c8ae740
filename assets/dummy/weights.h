#pragma once

#include <vector>

#include "assets/dummy/skeleton.h"
#include "assets/dummy/skinned_mesh.h"
#include "assets/dummy/surface_mesh.h"

namespace stretch::assets {

/// How every vertex follows the joints: it belongs to the bone that it is nearest to, and belonging then
/// diffuses over the surface (so it cannot leap from arm to chest), wider at the shoulders and hips than at
/// elbows and wrists. The four strongest stay; weights are multiples of 1/4096 and sum to exactly 1.
[[nodiscard]] std::vector<Influences> smoothWeights(const SurfaceMesh& mesh,
                                                    const std::vector<Joint>& skeleton);

} // namespace stretch::assets

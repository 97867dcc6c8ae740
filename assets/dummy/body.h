#pragma once

#include "assets/dummy/skeleton.h"
#include "assets/dummy/skinned_mesh.h"

namespace stretch::assets {

/// The dummy's body: one closed surface whose vertices are doubled where two colours meet.
[[nodiscard]] SkinnedMesh makeBody(const std::vector<Joint>& skeleton);

} // namespace stretch::assets

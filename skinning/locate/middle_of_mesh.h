#pragma once

#include <span>
#include <vector>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// The place moved across the direction `along` to the middle of the mesh around it: halfway between what is
/// met first both ways. A place from which some way out meets nothing stays.
[[nodiscard]] Vec3 middleOfMesh(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                                const Vec3& place, const Vec3& along);

} // namespace stretch::skinning

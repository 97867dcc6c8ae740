#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "skinning/bind/voxel_body.h"

namespace stretch::skinning {

/// For each vertex a point just behind the surface: where two parts touch, it lies in the vertex's own one.
/// Which side is behind is told by the depth of the body there, for each shell; `welded`: see weldedVertices.
/// The vertex itself where nothing was filled behind it.
[[nodiscard]] std::vector<Vec3> pointsBehind(const VoxelBody& body, std::span<const glm::vec3> positions,
                                             const std::vector<Triangle>& triangles,
                                             const std::vector<std::uint32_t>& welded);

} // namespace stretch::skinning

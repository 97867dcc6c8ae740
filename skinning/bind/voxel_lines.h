#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "skinning/bind/voxel_body.h"

namespace stretch::skinning {

/// One number for each cube of a grid.
using Cubes = std::vector<std::uint8_t>;

/// How many of three lines through a cube's middle, along the axes, are inside the triangles there: they have
/// gone in an odd number of times. A line that meets a hole, and so comes out as often as it went in plus or
/// minus one, says nothing.
[[nodiscard]] Cubes votesOfLines(const VoxelGrid& grid, std::span<const glm::vec3> positions,
                                 const std::vector<Triangle>& triangles);

} // namespace stretch::skinning

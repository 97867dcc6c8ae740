#pragma once

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "skinning/locate/standing_body.h"

namespace stretch::test {

/// A standing body of those cubes of 0..counts that are filled, each `size` wide, the first one's lowest
/// corner at `low`; its grid has an empty cube all around. Made without a mesh.
[[nodiscard]] skinning::StandingBody bodyOfCubes(const glm::ivec3& counts, double size, const Vec3& low,
                                                 const std::function<bool(int, int, int)>& filled);

/// The regions of each layer, found by joining pairs of cells: the independent way.
[[nodiscard]] std::vector<std::vector<skinning::SliceRegion>> layersByPairs(const skinning::VoxelBody& cubes);

/// For each cell the shortest way from any of the others, found by going over all cells until none changes.
[[nodiscard]] std::vector<double> waysByRounds(const skinning::VoxelBody& cubes,
                                               const std::vector<std::uint32_t>& from);

} // namespace stretch::test

#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/math/types.h"

namespace stretch::assets {

/// A closed triangle surface: counter-clockwise seen from outside.
struct SurfaceMesh {
  std::vector<Vec3> positions; ///< Metres.
  std::vector<std::array<int, 3>> triangles;
};

using DistanceField = std::function<double(const Vec3&)>;

/// Surface nets: one vertex in every cell of a grid that the zero level passes through, at the mean of the
/// cell's edge crossings. `low` and `high` span a box that holds the whole shape; `cell` is the spacing,
/// metres.
[[nodiscard]] SurfaceMesh polygonize(const DistanceField& distance, const Vec3& low, const Vec3& high,
                                     double cell);

/// Per vertex, the distinct vertices that an edge joins it to, ascending.
[[nodiscard]] std::vector<std::vector<int>> vertexNeighbours(const SurfaceMesh& mesh);

} // namespace stretch::assets

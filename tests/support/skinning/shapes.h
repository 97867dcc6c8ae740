#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/scene/mesh_sequence.h"

namespace stretch::test {

struct Shape {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles; ///< Wound outwards where there is an outside.
};

/// Unit sphere from an icosahedron, every triangle cut in four `levels` times.
[[nodiscard]] Shape sphere(int levels);

/// Square 0..1 in x and z with (cells + 1)^2 vertices; inner vertices are moved by a fixed pattern of at most
/// `jitter` cells, so that obtuse triangles appear.
[[nodiscard]] Shape plane(int cells, double jitter);

/// Torus around y: `around` times `across` vertices.
[[nodiscard]] Shape torus(double majorRadius, double minorRadius, int around, int across);

/// Closed tube along x from 0 to `length`: `rings` + 1 rings of `sides` vertices and a vertex in the middle
/// of each end.
[[nodiscard]] Shape tube(double length, double radius, int rings, int sides);

/// The surface of the cubes of a grid, from cell `low` up to but not with `high`, that are filled; corners
/// that cubes share are one vertex. Cells are `size` wide, cell (0, 0, 0) begins at the origin.
[[nodiscard]] Shape cubes(const glm::ivec3& low, const glm::ivec3& high, double size,
                          const std::function<bool(int, int, int)>& filled);

/// The surface of a box of so many cubes, of one size, from the origin on.
[[nodiscard]] Shape box(const glm::ivec3& counts, double size);

/// A sequence of one frame.
[[nodiscard]] MeshSequence still(const Shape& shape);

} // namespace stretch::test

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Cubes of one size over a box, in the space of the mesh.
struct VoxelGrid {
  Vec3 origin{0.0}; ///< The lowest corner of the first cube.
  double size = 1.0;
  std::array<int, 3> counts{1, 1, 1};

  [[nodiscard]] std::size_t cubeCount() const;
  [[nodiscard]] bool contains(const std::array<int, 3>& place) const;
  [[nodiscard]] std::size_t indexOf(const std::array<int, 3>& place) const;
  /// The cube that a point lies in; the nearest one for points outside.
  [[nodiscard]] std::array<int, 3> placeOf(const Vec3& point) const;
  [[nodiscard]] Vec3 middleOf(const std::array<int, 3>& place) const;
  [[nodiscard]] std::array<int, 3> placeOfIndex(std::size_t index) const;
};

/// A body as cubes: those that its surface passes and those that it encloses. Any triangles will do: holes,
/// several shells, inner faces and triangles without neighbours only make it less full.
struct VoxelBody {
  static constexpr std::int32_t outside = -1;

  VoxelGrid grid;
  std::vector<std::int32_t> cellAt;  ///< For each cube its cell, or `outside`.
  std::vector<std::uint32_t> cubeOf; ///< For each cell its cube.
  std::vector<float> depths;         ///< For each cell how far it is from the outside, units of the mesh.

  [[nodiscard]] std::size_t cellCount() const { return cubeOf.size(); }
  [[nodiscard]] Vec3 middleOf(std::size_t cell) const {
    return grid.middleOf(grid.placeOfIndex(cubeOf[cell]));
  }
  /// The cell that a point lies in, or the nearest one within a few cubes; `outside` where there is none.
  [[nodiscard]] std::int32_t cellNear(const Vec3& point, int cubesAround) const;
};

/// `cubesAlong`: how many cubes the longest side of the mesh's box takes at most; a mesh of few triangles
/// that encloses much shows nothing by so many, and takes 32 or more. Error: no triangle, a mesh without
/// extent or with places that are no numbers, triangles that join any vertices of the mesh with any others.
[[nodiscard]] Result<VoxelBody> voxelBody(std::span<const glm::vec3> positions,
                                          const std::vector<Triangle>& triangles, int cubesAlong);

} // namespace stretch::skinning

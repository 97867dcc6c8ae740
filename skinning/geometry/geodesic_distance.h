#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Distances over a surface by fast marching (Kimmel and Sethian 1998). A vertex is updated from two others
/// of a triangle through the point source that would explain their distances, which is exact on a plane;
/// where the angle at the vertex is obtuse, the triangles beyond the far edge are unfolded into the plane
/// until one of their vertices splits the angle. Works on surfaces with boundaries, several parts and edges
/// of more than two triangles. Built once for each mesh, asked often.
class GeodesicSolver {
public:
  GeodesicSolver(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles);
  ~GeodesicSolver();
  GeodesicSolver(GeodesicSolver&&) noexcept;
  GeodesicSolver& operator=(GeodesicSolver&&) noexcept;

  /// Distance of every vertex from the nearest source, in mesh units; infinite where no path leads or the
  /// path would be longer than `limit`. Safe to call from several threads.
  [[nodiscard]] std::vector<double> distances(const std::vector<std::uint32_t>& sources,
                                              double limit = std::numeric_limits<double>::infinity()) const;

private:
  struct Stencils;
  std::unique_ptr<const Stencils> stencils_;
};

} // namespace stretch::skinning

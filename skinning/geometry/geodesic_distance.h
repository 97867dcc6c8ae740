#pragma once

#include <cstdint>
#include <limits>
#include <memory>
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
  GeodesicSolver(const glm::vec3* positions, std::size_t vertexCount, const std::vector<Triangle>& triangles);
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

/// The one-off: builds the solver and asks it once.
[[nodiscard]] std::vector<double> geodesicDistances(const glm::vec3* positions, std::size_t vertexCount,
                                                    const std::vector<Triangle>& triangles,
                                                    const std::vector<std::uint32_t>& sources);

} // namespace stretch::skinning

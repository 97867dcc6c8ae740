#pragma once

#include "assets/dummy/surface_mesh.h"

namespace stretch::assets {

struct RemeshSettings {
  std::function<double(const Vec3&)> edgeLength; ///< Wanted edge length at a point, metres.
  std::function<Vec3(const Vec3&)> project;      ///< Moves a point near the surface onto it.
  std::function<Vec3(const Vec3&)> normal;       ///< Unit normal of the surface at a point on it.
  int iterations = 8;
};

/// Even triangles of the wanted size: split long edges, collapse short ones, flip towards valence six, relax
/// in the tangent plane and project, as in Botsch and Kobbelt, "A Remeshing Approach to Multiresolution
/// Modeling" (2004). The mesh must be closed and manifold, and stays so.
[[nodiscard]] SurfaceMesh remesh(const SurfaceMesh& mesh, const RemeshSettings& settings);

} // namespace stretch::assets

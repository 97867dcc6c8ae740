#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/scene/mesh_sequence.h"

// The seam to OpenMesh: included by .cpp files of this folder only.
namespace stretch::skinning {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// A surface as half-edges. Where three or more triangles meet at an edge, or pieces touch at a single vertex
/// in a way that half-edges cannot hold, the later triangles get vertices of their own: the surface is cut
/// open there and every vertex remembers which of the original ones it is.
struct HalfEdgeMesh {
  HalfEdges edges;
  std::vector<std::uint32_t> original; ///< One for each vertex of `edges`.
  std::vector<std::uint32_t> triangle; ///< One for each face of `edges`: index of the triangle it is.
};

/// Triangles are wound alike first (over edges of two triangles); those with a repeated corner are left out.
[[nodiscard]] HalfEdgeMesh buildHalfEdges(const glm::vec3* positions, std::size_t vertexCount,
                                          const std::vector<Triangle>& triangles);

} // namespace stretch::skinning

#include "skinning/geometry/half_edge_mesh.h"

#include <array>

#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

using Corners = std::array<HalfEdges::VertexHandle, 3>;

HalfEdges::Point pointOf(const glm::vec3& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// Whether the half-edges can take a triangle with these corners: its edges are free on this side, its
/// corners open.
bool fits(const HalfEdges& edges, const Corners& corners) {
  for (std::size_t c = 0; c < 3; ++c) {
    const HalfEdges::HalfedgeHandle side(edges.find_halfedge(corners[c], corners[(c + 1) % 3]).idx());
    if (!edges.is_boundary(corners[c]) || (side.is_valid() && !edges.is_boundary(side))) {
      return false;
    }
  }
  return true;
}

void addTriangle(HalfEdgeMesh& mesh, const Corners& corners, std::uint32_t index) {
  if (mesh.edges.add_face(corners[0], corners[1], corners[2]).is_valid()) {
    mesh.triangle.push_back(index);
  }
}

} // namespace

HalfEdgeMesh buildHalfEdges(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  std::vector<Triangle> wound = triangles;
  orientOutwards(positions, wound);
  HalfEdgeMesh mesh;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    mesh.edges.add_vertex(pointOf(positions[v]));
    mesh.original.push_back(static_cast<std::uint32_t>(v));
  }
  for (std::size_t t = 0; t < wound.size(); ++t) {
    const Triangle& triangle = wound[t];
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      continue;
    }
    Corners corners;
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c] = HalfEdges::VertexHandle(static_cast<int>(triangle[c]));
    }
    if (!fits(mesh.edges, corners)) {
      for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = HalfEdges::VertexHandle(mesh.edges.add_vertex(pointOf(positions[triangle[c]])).idx());
        mesh.original.push_back(triangle[c]);
      }
    }
    addTriangle(mesh, corners, static_cast<std::uint32_t>(t));
  }
  return mesh;
}

} // namespace stretch::skinning

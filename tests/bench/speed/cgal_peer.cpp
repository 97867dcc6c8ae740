#include "tests/bench/speed/cgal_peer.h"

#if __has_include(<CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>)
#define STRETCH_HAS_CGAL 1
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#endif

#include "core/base/check.h"

namespace stretch::bench {

#ifdef STRETCH_HAS_CGAL

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh meshOf(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const glm::vec3& p : positions) {
    vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  }
  for (const Triangle& triangle : triangles) {
    mesh.add_face(vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]);
  }
  check(mesh.number_of_faces() == triangles.size(), "CGAL takes the bench's mesh");
  return mesh;
}

} // namespace

bool hasCgal() {
  return true;
}

void cgalThickness(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  Mesh mesh = meshOf(positions, triangles);
  const auto values = mesh.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  constexpr std::size_t rays = 64;
  CGAL::sdf_values(mesh, values, 2.0 / 3.0 * CGAL_PI, rays, true);
}

void cgalDistances(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                   const std::vector<std::uint32_t>& sources) {
  Mesh mesh = meshOf(positions, triangles);
  const auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.0).first;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh> heat(mesh);
  for (const std::uint32_t source : sources) {
    heat.clear_sources();
    heat.add_source(Mesh::Vertex_index(source));
    heat.estimate_geodesic_distances(values);
  }
}

#else

bool hasCgal() {
  return false;
}

void cgalThickness(std::span<const glm::vec3> /*positions*/, const std::vector<Triangle>& /*triangles*/) {}

void cgalDistances(std::span<const glm::vec3> /*positions*/, const std::vector<Triangle>& /*triangles*/,
                   const std::vector<std::uint32_t>& /*sources*/) {}

#endif

} // namespace stretch::bench

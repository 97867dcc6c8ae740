#include "skinning/bind/points_behind.h"

#include <algorithm>

#include "skinning/bind/stiff_shells.h"

namespace stretch::skinning {

namespace {

// Out of the triangles around each place, as they are wound; zero where there are none.
std::vector<Vec3> normalsOf(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                            const std::vector<std::uint32_t>& welded) {
  std::vector<Vec3> normals(positions.size(), Vec3(0.0));
  for (const Triangle& triangle : triangles) {
    const Vec3 corner(positions[triangle[0]]);
    const Vec3 face =
        glm::cross(Vec3(positions[triangle[1]]) - corner, Vec3(positions[triangle[2]]) - corner);
    for (const std::uint32_t vertex : triangle) {
      normals[welded[vertex]] += face;
    }
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3& sum = normals[welded[v]];
    const double length = glm::length(sum);
    normals[v] = length > 0.0 ? sum / length : Vec3(0.0);
  }
  return normals;
}

double depthAt(const VoxelBody& body, const Vec3& point) {
  const std::int32_t cell = body.cellAt[body.grid.indexOf(body.grid.placeOf(point))];
  return cell == VoxelBody::outside ? 0.0 : static_cast<double>(body.depths[static_cast<std::size_t>(cell)]);
}

} // namespace

std::vector<Vec3> pointsBehind(const VoxelBody& body, std::span<const glm::vec3> positions,
                               const std::vector<Triangle>& triangles,
                               const std::vector<std::uint32_t>& welded) {
  const std::vector<Vec3> normals = normalsOf(positions, triangles, welded);
  const std::vector<std::size_t> shells = shellsOf(welded, triangles);
  std::vector<double> inwards(positions.size(), 0.0); // of each shell: negative where normals point outwards
  constexpr double probe = 1.5;                       // cubes
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 step = probe * body.grid.size * normals[v];
    inwards[shells[v]] += depthAt(body, Vec3(positions[v]) + step) - depthAt(body, Vec3(positions[v]) - step);
  }
  constexpr double behind = 0.75; // cubes
  std::vector<Vec3> points(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double side = inwards[shells[v]] < 0.0 ? -1.0 : 1.0;
    const Vec3 place(positions[v]);
    const Vec3 point = place + side * behind * body.grid.size * normals[v];
    points[v] = depthAt(body, point) > 0.0 ? point : place;
  }
  return points;
}

} // namespace stretch::skinning

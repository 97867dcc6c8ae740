#include "assets/dummy/slivers.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace stretch::assets {

namespace {

/// Height over longest side: 0 for a degenerate triangle, 0.87 for an equilateral one.
double roundness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
  return glm::length(glm::cross(b - a, c - a)) / longest;
}

bool isFlat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 one = glm::cross(b - a, c - a);
  const Vec3 two = glm::cross(d - a, b - a);
  return glm::dot(one, two) > 0.85 * glm::length(one) * glm::length(two);
}

bool improves(const EditableMesh& mesh, const Edge& edge, const std::function<int(const Vec3&)>& regionOf) {
  constexpr double sliver = 0.12;
  const std::array<int, 2> across = mesh.opposite(edge);
  const Vec3& a = mesh.position(edge[0]);
  const Vec3& b = mesh.position(edge[1]);
  const Vec3& c = mesh.position(across[0]);
  const Vec3& d = mesh.position(across[1]);
  const double before = std::min(roundness(a, b, c), roundness(a, b, d));
  const double after = std::min(roundness(c, d, a), roundness(c, d, b));
  if (after < 1.1 * before || !(before < sliver || isFlat(a, b, c, d))) {
    return false;
  }
  return regionOf((a + b + c) / 3.0) == regionOf((a + b + d) / 3.0) && mesh.canFlip(edge);
}

} // namespace

void mergeCoincident(EditableMesh& mesh) {
  constexpr double closest = 0.001;
  for (const Edge& edge : mesh.edges()) {
    if (mesh.isEdge(edge) && mesh.length(edge) < closest && mesh.canCollapse(edge, mesh.position(edge[0]))) {
      mesh.collapse(edge, Vec3(mesh.position(edge[0])));
    }
  }
}

void flipSlivers(EditableMesh& mesh, const std::function<int(const Vec3&)>& regionOf) {
  for (int pass = 0; pass < 3; ++pass) {
    for (const Edge& edge : mesh.edges()) {
      if (mesh.isEdge(edge) && improves(mesh, edge, regionOf)) {
        mesh.flip(edge);
      }
    }
  }
}

} // namespace stretch::assets

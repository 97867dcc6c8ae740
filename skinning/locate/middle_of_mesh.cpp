#include "skinning/locate/middle_of_mesh.h"

#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

namespace stretch::skinning {

namespace {

constexpr double nothing = std::numeric_limits<double>::max();

// Distance along a ray of unit length to a triangle (T. Moeller and B. Trumbore, 1997).
double distanceTo(const std::array<Vec3, 3>& corners, const Vec3& origin, const Vec3& direction) {
  const Vec3 first = corners[1] - corners[0];
  const Vec3 second = corners[2] - corners[0];
  const Vec3 across = glm::cross(direction, second);
  const double determinant = glm::dot(first, across);
  if (determinant == 0.0) {
    return nothing;
  }
  const Vec3 from = origin - corners[0];
  const double u = glm::dot(from, across) / determinant;
  const Vec3 turned = glm::cross(from, first);
  const double v = glm::dot(direction, turned) / determinant;
  const double distance = glm::dot(second, turned) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 ? distance : nothing;
}

double firstHit(std::span<const Vec3> positions, const std::vector<Triangle>& triangles, const Vec3& origin,
                const Vec3& direction) {
  double nearest = nothing;
  for (const Triangle& triangle : triangles) {
    nearest =
        std::min(nearest, distanceTo({positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]},
                                     origin, direction));
  }
  return nearest;
}

} // namespace

Vec3 middleOfMesh(std::span<const Vec3> positions, const std::vector<Triangle>& triangles, const Vec3& place,
                  const Vec3& along) {
  constexpr int rounds = 2; // what the first changes across one way, the second sees the other way
  const Vec3 axis = glm::normalize(along);
  const Vec3 sideways = anyPerpendicular(axis);
  Vec3 middle = place;
  for (int round = 0; round < rounds; ++round) {
    for (const Vec3& direction : {sideways, glm::cross(axis, sideways)}) {
      const double on = firstHit(positions, triangles, middle, direction);
      const double back = firstHit(positions, triangles, middle, -direction);
      if (on == nothing || back == nothing) {
        return place;
      }
      middle += 0.5 * (on - back) * direction;
    }
  }
  return middle;
}

} // namespace stretch::skinning

#include "skinning/geometry/inside.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::skinning {

namespace {

double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  return 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

double distanceFromEdge(const Vec3& place, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = glm::dot(way, way);
  const double share = length > 0.0 ? std::clamp(glm::dot(place - a, way) / length, 0.0, 1.0) : 0.0;
  return glm::length(place - a - share * way);
}

double distanceFromTriangle(const Vec3& place, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = glm::cross(b - a, c - a);
  const auto isWithin = [&](const Vec3& from, const Vec3& to) {
    return glm::dot(glm::cross(to - from, place - from), normal) >= 0.0;
  };
  const double size = glm::length(normal);
  if (size > 0.0 && isWithin(a, b) && isWithin(b, c) && isWithin(c, a)) {
    return std::abs(glm::dot(place - a, normal)) / size;
  }
  return std::min(
      {distanceFromEdge(place, a, b), distanceFromEdge(place, b, c), distanceFromEdge(place, c, a)});
}

} // namespace

double windingNumber(const PlacedSurface& surface, const Vec3& place) {
  double sum = 0.0;
  for (const Triangle& triangle : surface.triangles) {
    sum += solidAngle(surface.places[triangle[0]] - place, surface.places[triangle[1]] - place,
                      surface.places[triangle[2]] - place);
  }
  return sum / (4.0 * pi);
}

double distanceFrom(const PlacedSurface& surface, const Vec3& place, double limit) {
  double nearest = limit;
  for (const Triangle& triangle : surface.triangles) {
    const Vec3& a = surface.places[triangle[0]];
    const Vec3& b = surface.places[triangle[1]];
    const Vec3& c = surface.places[triangle[2]];
    const Vec3 toBox = glm::max(
        glm::max(glm::min(glm::min(a, b), c) - place, place - glm::max(glm::max(a, b), c)), Vec3(0.0));
    if (glm::dot(toBox, toBox) < nearest * nearest) {
      nearest = std::min(nearest, distanceFromTriangle(place, a, b, c));
    }
  }
  return nearest;
}

} // namespace stretch::skinning

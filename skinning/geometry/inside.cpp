#include "skinning/geometry/inside.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/index.h"

namespace stretch::skinning {

namespace {

double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  return 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

// Shares of the point of the way from corner `first` to corner `second` that is nearest to the place.
Vec3 nearestOnEdge(const std::array<Vec3, 3>& corners, int first, int second, const Vec3& place) {
  const Vec3 way = corners[at(second)] - corners[at(first)];
  const double length = glm::dot(way, way);
  const double share =
      length > 0.0 ? std::clamp(glm::dot(place - corners[at(first)], way) / length, 0.0, 1.0) : 0.0;
  Vec3 shares(0.0);
  shares[first] = 1.0 - share;
  shares[second] = share;
  return shares;
}

Vec3 placeAt(const std::array<Vec3, 3>& corners, const Vec3& shares) {
  return shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
}

// Shares of the nearest point of a triangle.
Vec3 nearestOnTriangle(const std::array<Vec3, 3>& corners, const Vec3& place) {
  const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = glm::dot(normal, normal);
  if (size > 0.0) {
    Vec3 shares(0.0);
    for (int i = 0; i < 3; ++i) {
      const Vec3& from = corners[at((i + 1) % 3)];
      shares[i] = glm::dot(glm::cross(corners[at((i + 2) % 3)] - from, place - from), normal) / size;
    }
    if (shares[0] >= 0.0 && shares[1] >= 0.0 && shares[2] >= 0.0) {
      return shares;
    }
  }
  Vec3 nearest(1.0, 0.0, 0.0);
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3 shares = nearestOnEdge(corners, i, (i + 1) % 3, place);
    const double far = glm::length(placeAt(corners, shares) - place);
    if (far < distance) {
      distance = far;
      nearest = shares;
    }
  }
  return nearest;
}

std::array<Vec3, 3> cornersOf(const PlacedSurface& surface, const Triangle& triangle) {
  return {surface.places[triangle[0]], surface.places[triangle[1]], surface.places[triangle[2]]};
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

Vec3 placeOf(const PlacedSurface& surface, const SurfacePoint& point) {
  return placeAt(cornersOf(surface, surface.triangles[point.triangle]), point.shares);
}

std::optional<SurfacePoint> nearestOn(const PlacedSurface& surface, const Vec3& place, double limit) {
  std::optional<SurfacePoint> found;
  double nearest = limit;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::array<Vec3, 3> corners = cornersOf(surface, surface.triangles[i]);
    const auto& [a, b, c] = corners;
    const Vec3 toBox = glm::max(
        glm::max(glm::min(glm::min(a, b), c) - place, place - glm::max(glm::max(a, b), c)), Vec3(0.0));
    if (glm::dot(toBox, toBox) >= nearest * nearest) {
      continue;
    }
    const Vec3 shares = nearestOnTriangle(corners, place);
    const double distance = glm::length(placeAt(corners, shares) - place);
    if (distance < nearest) {
      nearest = distance;
      found = SurfacePoint{i, shares};
    }
  }
  return found;
}

std::vector<SurfacePoint> crossedBy(const PlacedSurface& surface, const Vec3& start, const Vec3& way) {
  std::vector<SurfacePoint> crossed;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::array<Vec3, 3> corners = cornersOf(surface, surface.triangles[i]);
    // start + t way = the corners by their shares (Moeller and Trumbore 1997).
    const Vec3 first = corners[1] - corners[0];
    const Vec3 second = corners[2] - corners[0];
    const Vec3 across = glm::cross(way, second);
    const double size = glm::dot(first, across);
    if (size == 0.0) {
      continue;
    }
    const Vec3 offset = start - corners[0];
    const Vec3 along = glm::cross(offset, first);
    const double ofFirst = glm::dot(offset, across) / size;
    const double ofSecond = glm::dot(way, along) / size;
    if (ofFirst >= 0.0 && ofSecond >= 0.0 && ofFirst + ofSecond <= 1.0 &&
        glm::dot(second, along) / size > 0.0) {
      crossed.push_back({i, {1.0 - ofFirst - ofSecond, ofFirst, ofSecond}});
    }
  }
  return crossed;
}

double distanceFrom(const PlacedSurface& surface, const Vec3& place, double limit) {
  const std::optional<SurfacePoint> nearest = nearestOn(surface, place, limit);
  return nearest ? glm::length(placeOf(surface, *nearest) - place) : limit;
}

} // namespace stretch::skinning

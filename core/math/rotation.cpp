#include "core/math/rotation.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace stretch {

Quat axisAngle(const Vec3& unitAxis, double angleRadians) {
  const double half = 0.5 * angleRadians;
  const Vec3 v = unitAxis * std::sin(half);
  return {std::cos(half), v.x, v.y, v.z};
}

Vec3 anyPerpendicular(const Vec3& direction) {
  const Vec3 helper = std::abs(direction.x) <= std::abs(direction.y) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 perpendicular = glm::cross(direction, helper);
  const double length = glm::length(perpendicular);
  return length > 0.0 ? perpendicular / length : Vec3(1, 0, 0);
}

Quat shortestArc(const Vec3& from, const Vec3& to) {
  const double scale = glm::length(from) * glm::length(to);
  if (!(scale > 0.0)) {
    return {1.0, 0.0, 0.0, 0.0};
  }
  const double cosine = glm::dot(from, to) / scale;
  if (cosine < -1.0 + 1e-12) {
    return axisAngle(anyPerpendicular(from), pi);
  }
  const Vec3 v = glm::cross(from, to) / scale;
  return glm::normalize(Quat(1.0 + cosine, v.x, v.y, v.z));
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

Vec3 anyAcross(const Vec3& axis) {
  const Vec3 helper = std::abs(axis.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  return glm::normalize(helper - glm::dot(helper, axis) * axis);
}

} // namespace stretch

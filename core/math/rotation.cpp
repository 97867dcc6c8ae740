#include "core/math/rotation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

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

double cosineBetween(const Vec3& a, const Vec3& b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0 ? glm::dot(a, b) / lengths : 0.0;
}

double angleBetween(const Quat& a, const Quat& b) {
  return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

bool isTurn(const Quat& rotation) {
  constexpr double unseen = 1e-11;
  return glm::length(Vec3(rotation.x, rotation.y, rotation.z)) > unseen;
}

} // namespace stretch

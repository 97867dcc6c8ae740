#include "core/math/euler.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

namespace stretch {

namespace {

double unwrapped(double angle, double previous) {
  return angle + 2.0 * pi * std::round((previous - angle) / (2.0 * pi));
}

} // namespace

Vec3 eulerNear(const Quat& rotation, const Vec3& previous) {
  const Vec3 angles = glm::eulerAngles(rotation);
  const Vec3 other(angles.x + pi, pi - angles.y, angles.z + pi); // the second set that says the same
  const auto near = [&](const Vec3& a) {
    return Vec3(unwrapped(a.x, previous.x), unwrapped(a.y, previous.y), unwrapped(a.z, previous.z));
  };
  const Vec3 first = near(angles);
  const Vec3 second = near(other);
  return glm::length(first - previous) <= glm::length(second - previous) ? first : second;
}

Quat rotationOf(const Vec3& angles) {
  return axisAngle({0.0, 0.0, 1.0}, angles.z) * axisAngle({0.0, 1.0, 0.0}, angles.y) *
         axisAngle({1.0, 0.0, 0.0}, angles.x);
}

Quat rotationRate(const Vec3& angles, const Vec3& rates) {
  const Quat x = axisAngle({1.0, 0.0, 0.0}, angles.x);
  const Quat y = axisAngle({0.0, 1.0, 0.0}, angles.y);
  const Quat z = axisAngle({0.0, 0.0, 1.0}, angles.z);
  const Quat turnX(0.0, 0.5 * rates.x, 0.0, 0.0);
  const Quat turnY(0.0, 0.0, 0.5 * rates.y, 0.0);
  const Quat turnZ(0.0, 0.0, 0.0, 0.5 * rates.z);
  return z * y * (turnX * x) + z * (turnY * y) * x + (turnZ * z) * y * x;
}

Vec3 eulerRate(const Quat& rotation, const Quat& rate, const Vec3& angles) {
  const double length = glm::length(rate);
  if (!(length > 1e-12)) {
    return Vec3(0.0);
  }
  const double step = 1e-5 * glm::length(rotation) / length;
  const Quat before = glm::normalize(rotation + rate * -step);
  const Quat after = glm::normalize(rotation + rate * step);
  return (eulerNear(after, angles) - eulerNear(before, angles)) / (2.0 * step);
}

} // namespace stretch

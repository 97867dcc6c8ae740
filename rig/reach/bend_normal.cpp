#include "rig/reach/bend_normal.h"

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

// Sum of the bend axes of the inner joints, each as long as the sine of its bend.
Vec3 bendOf(const std::vector<Vec3>& points) {
  Vec3 bend(0.0);
  for (std::size_t i = 2; i < points.size(); ++i) {
    const Vec3 before = points[i - 1] - points[i - 2];
    const Vec3 after = points[i] - points[i - 1];
    const double lengths = glm::length(before) * glm::length(after);
    if (lengths > 0.0) {
      bend += glm::cross(before, after) / lengths;
    }
  }
  return bend;
}

} // namespace

void BendNormal::add(const std::vector<Vec3>& points, const Quat& baseRotation) {
  sum_ += glm::inverse(baseRotation) * bendOf(points);
}

Vec3 BendNormal::at(const std::vector<Vec3>& points, const Quat& baseRotation) const {
  constexpr double leastBend = 1e-9;
  if (glm::length(sum_) < leastBend) {
    return Vec3(0.0);
  }
  const Vec3 average = glm::normalize(baseRotation * sum_);
  const Vec3 bend = bendOf(points);
  // The pose decides where it is clearly bent, the average where it is nearly straight. A limb bent backwards
  // keeps the average's side: the solver tells the side by the sign.
  constexpr double averageShare = 0.1;
  const double side = glm::dot(bend, average) < 0.0 ? -1.0 : 1.0;
  return glm::normalize(side * bend + averageShare * average);
}

} // namespace stretch::rig

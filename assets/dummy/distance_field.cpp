#include "assets/dummy/distance_field.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace stretch::assets {

double ellipsoidDistance(const Vec3& point, const Vec3& center, const Vec3& radii) {
  const Vec3 scaled = (point - center) / radii;
  const double level = glm::length(scaled);
  const double slope = glm::length(scaled / radii);
  if (slope < 1e-9) {
    return -std::min({radii.x, radii.y, radii.z});
  }
  return level * (level - 1.0) / slope;
}

double ellipsoidDistance(const Vec3& point, const Vec3& center, const Vec3& radii, const Mat3& axes) {
  return ellipsoidDistance(glm::transpose(axes) * (point - center), Vec3(0.0), radii);
}

double roundConeDistance(const Vec3& point, const Vec3& start, const Vec3& end, double startRadius,
                         double endRadius) {
  const Vec3 axis = end - start;
  const double length = glm::length(axis);
  const double slope = (startRadius - endRadius) / length;
  if (slope * slope >= 1.0) {
    return std::min(sphereDistance(point, start, startRadius), sphereDistance(point, end, endRadius));
  }
  const Vec3 offset = point - start;
  const double along = glm::dot(offset, axis) / length;
  const double across = std::sqrt(std::max(0.0, glm::dot(offset, offset) - along * along));
  const double cosine = std::sqrt(1.0 - slope * slope);
  // The point's foot on the axis, seen along the normal of the cone's side.
  const double foot = along + across * -slope / cosine;
  if (foot <= 0.0) {
    return std::sqrt(along * along + across * across) - startRadius;
  }
  if (foot >= length) {
    return std::sqrt((along - length) * (along - length) + across * across) - endRadius;
  }
  return across * cosine + along * slope - startRadius;
}

double sphereDistance(const Vec3& point, const Vec3& center, double radius) {
  return glm::length(point - center) - radius;
}

double smoothUnion(double a, double b, double width) {
  if (width <= 0.0) {
    return std::min(a, b);
  }
  const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - overlap * overlap * overlap * width / 6.0;
}

double smoothIntersection(double a, double b, double width) {
  return -smoothUnion(-a, -b, width);
}

} // namespace stretch::assets

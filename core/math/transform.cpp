#include "core/math/transform.h"

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

namespace stretch {

namespace {

struct LinearParts {
  Quat rotation;
  Vec3 scale;
};

// The axis of a column; where the column is zero, the one that completes the other two (in their cyclic
// order).
Vec3 axisOf(const Vec3& column, const Vec3& next, const Vec3& afterNext) {
  if (glm::length(column) > 0.0) {
    return glm::normalize(column);
  }
  const Vec3 completing = glm::cross(next, afterNext);
  if (glm::length(completing) > 0.0) {
    return glm::normalize(completing);
  }
  const Vec3 other = glm::length(next) > 0.0 ? next : afterNext;
  return glm::length(other) > 0.0 ? anyPerpendicular(glm::normalize(other)) : Vec3(1, 0, 0);
}

LinearParts split(const Mat4& matrix) {
  const Vec3 x(matrix[0]);
  const Vec3 y(matrix[1]);
  const Vec3 z(matrix[2]);
  Vec3 scale(glm::length(x), glm::length(y), glm::length(z));
  const Vec3 unitX = axisOf(x, y, z);
  Vec3 unitY = axisOf(y, z, unitX);
  unitY -= unitX * glm::dot(unitX, unitY);
  unitY = glm::length(unitY) > 1e-12 ? glm::normalize(unitY) : anyPerpendicular(unitX);
  const Vec3 unitZ = glm::cross(unitX, unitY);
  if (glm::dot(unitZ, z) >= 0.0) {
    return {glm::normalize(glm::quat_cast(Mat3(unitX, unitY, unitZ))), scale};
  }
  // A mirror: the x axis carries the minus sign, so that the other two and the rotation stay a right-handed
  // frame.
  scale.x = -scale.x;
  return {glm::normalize(glm::quat_cast(Mat3(-unitX, unitY, -unitZ))), scale};
}

} // namespace

Mat4 toMatrix(const Transform& transform) {
  const Mat3 rotation = glm::mat3_cast(transform.rotation);
  return {Vec4(rotation[0] * transform.scale.x, 0.0), Vec4(rotation[1] * transform.scale.y, 0.0),
          Vec4(rotation[2] * transform.scale.z, 0.0), Vec4(transform.translation, 1.0)};
}

Transform toTransform(const Mat4& matrix) {
  const LinearParts parts = split(matrix);
  return {Vec3(matrix[3]), parts.rotation, parts.scale};
}

Quat rotationOf(const Mat4& matrix) {
  return split(matrix).rotation;
}

} // namespace stretch

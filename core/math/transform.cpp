#include "core/math/transform.h"

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

namespace stretch {

namespace {

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

// Two of the three axes of a matrix: unit, and perpendicular to each other.
struct Axes {
  Vec3 x;
  Vec3 y;
};

// The y axis freed of what it has of the x axis; any perpendicular where they are parallel.
Axes perpendicular(const Vec3& unitX, const Vec3& axisY) {
  const Vec3 across = axisY - unitX * glm::dot(unitX, axisY);
  const double length = glm::length(across);
  return {unitX, length > 1e-12 ? across / length : anyPerpendicular(unitX)};
}

Axes axesOf(const Vec3& x, const Vec3& y, const Vec3& z) {
  const double lengthX = glm::length(x);
  const double lengthY = glm::length(y);
  if (lengthX > 0.0 && lengthY > 0.0) {
    return perpendicular(x / lengthX, y / lengthY);
  }
  const Vec3 unitX = axisOf(x, y, z);
  return perpendicular(unitX, axisOf(y, z, unitX));
}

struct Turned {
  Quat rotation;
  bool isMirrored = false;
};

Turned turnedOf(const Mat4& matrix) {
  const Vec3 z(matrix[2]);
  const Axes axes = axesOf(Vec3(matrix[0]), Vec3(matrix[1]), z);
  const Vec3 unitZ = glm::cross(axes.x, axes.y);
  if (glm::dot(unitZ, z) >= 0.0) {
    return {glm::quat_cast(Mat3(axes.x, axes.y, unitZ)), false};
  }
  // A mirror: the x axis carries the minus sign, so that the other two and the rotation stay a right-handed
  // frame.
  return {glm::quat_cast(Mat3(-axes.x, axes.y, -unitZ)), true};
}

} // namespace

Mat4 toMatrix(const Transform& transform) {
  const Mat3 rotation = glm::mat3_cast(transform.rotation);
  return {Vec4(rotation[0] * transform.scale.x, 0.0), Vec4(rotation[1] * transform.scale.y, 0.0),
          Vec4(rotation[2] * transform.scale.z, 0.0), Vec4(transform.translation, 1.0)};
}

Transform toTransform(const Mat4& matrix) {
  const Turned turned = turnedOf(matrix);
  Vec3 scale(glm::length(Vec3(matrix[0])), glm::length(Vec3(matrix[1])), glm::length(Vec3(matrix[2])));
  scale.x = turned.isMirrored ? -scale.x : scale.x;
  return {Vec3(matrix[3]), turned.rotation, scale};
}

Quat rotationOf(const Mat4& matrix) {
  return turnedOf(matrix).rotation;
}

} // namespace stretch

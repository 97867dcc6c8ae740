#pragma once

#include "core/math/types.h"

namespace stretch {

/// Translation, rotation, scale, as glTF nodes hold them: p -> translation + rotation * (scale * p).
struct Transform {
  Vec3 translation{0.0};
  Quat rotation{1.0, 0.0, 0.0, 0.0};
  Vec3 scale{1.0};

  friend bool operator==(const Transform&, const Transform&) = default;
};

[[nodiscard]] Mat4 toMatrix(const Transform& transform);

/// Nearest TRS of an affine matrix: column lengths as scale (a mirrored matrix gets a negative x), the rest
/// made a rotation by orthonormalising. Exact when the matrix has no shear. A zero column gives scale 0 and a
/// completed axis.
[[nodiscard]] Transform toTransform(const Mat4& matrix);

/// Rotation part of an affine matrix, as toTransform finds it.
[[nodiscard]] Quat rotationOf(const Mat4& matrix);

[[nodiscard]] inline Vec3 positionOf(const Mat4& matrix) {
  return Vec3(matrix[3]);
}
[[nodiscard]] inline Vec3 transformPoint(const Mat4& matrix, const Vec3& point) {
  return Vec3(matrix * Vec4(point, 1.0));
}
[[nodiscard]] inline Vec3 transformVector(const Mat4& matrix, const Vec3& vector) {
  return Vec3(matrix * Vec4(vector, 0.0));
}

} // namespace stretch

#pragma once

#include <assimp/matrix4x4.h>
#include <assimp/quaternion.h>
#include <assimp/vector3.h>

#include "core/math/types.h"

namespace stretch::interchange {

[[nodiscard]] inline Vec3 vectorOf(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}
[[nodiscard]] inline Quat quaternionOf(const aiQuaternion& q) {
  return {q.w, q.x, q.y, q.z};
}
/// The library's matrices are written row by row.
[[nodiscard]] inline Mat4 matrixOf(const aiMatrix4x4& m) {
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

} // namespace stretch::interchange

#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/math/types.h"

namespace stretch::skinning {

/// Places as signed 16-bit integers: a cube around all of them, the same steps along every axis, so that
/// normals keep their directions.
struct MeshGrid {
  Vec3 centre{0.0};
  double halfSize = 1.0; ///< From the centre to the sides of the cube; > 0.

  [[nodiscard]] std::array<std::int16_t, 3> of(const Vec3& place) const {
    const Vec3 steps = (place - centre) / halfSize * 32767.0;
    return {static_cast<std::int16_t>(std::lround(steps.x)), static_cast<std::int16_t>(std::lround(steps.y)),
            static_cast<std::int16_t>(std::lround(steps.z))};
  }
  /// From the integers, read as -1..1, to the places: belongs into the inverse bind matrices, since a skinned
  /// mesh knows no other transform.
  [[nodiscard]] Mat4 toPlaces() const {
    Mat4 matrix(halfSize);
    matrix[3] = Vec4(centre, 1.0);
    return matrix;
  }
};

[[nodiscard]] MeshGrid gridAround(std::span<const glm::vec3> places);

} // namespace stretch::skinning

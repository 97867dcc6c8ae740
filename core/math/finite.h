#pragma once

#include <cmath>

#include "core/math/types.h"

namespace stretch {

[[nodiscard]] inline bool isFinite(const Vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

[[nodiscard]] inline bool isFinite(const Mat4& matrix) {
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) {
        return false;
      }
    }
  }
  return true;
}

} // namespace stretch

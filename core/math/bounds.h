#pragma once

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

#include "core/math/types.h"

namespace stretch {

/// The axis-aligned box around points; empty before the first one.
struct Bounds {
  Vec3 low{std::numeric_limits<double>::max()};
  Vec3 high{std::numeric_limits<double>::lowest()};

  void add(const Vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  [[nodiscard]] bool empty() const { return low.x > high.x; }
  /// Length of the longest side; 0 when empty.
  [[nodiscard]] double largestExtent() const {
    const Vec3 extent = high - low;
    return std::max({extent.x, extent.y, extent.z, 0.0});
  }
};

} // namespace stretch

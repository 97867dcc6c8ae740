#pragma once

#include <vector>

#include <glm/geometric.hpp>

#include "core/math/types.h"

namespace stretch {

/// Returns the length of the line from its first point to each of its points, in order, 0 at the first; a 0
/// alone without points.
[[nodiscard]] inline std::vector<double> lengthsAlong(const std::vector<Vec3>& points) {
  std::vector<double> lengths{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths.push_back(lengths.back() + glm::length(points[i] - points[i - 1]));
  }
  return lengths;
}

/// Returns the length of the line through the points; 0 for fewer than two.
[[nodiscard]] inline double polylineLength(const std::vector<Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += glm::length(points[i] - points[i - 1]);
  }
  return length;
}

} // namespace stretch

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// A triangle seen along an axis: a point on it is met where its weights are not negative.
class SeenTriangle {
public:
  SeenTriangle(std::span<const glm::vec3> positions, const Triangle& triangle, glm::length_t axis)
      : axis_(axis), a_((axis + 1) % 3), b_((axis + 2) % 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      corners_[i] = Vec3(positions[triangle[i]]);
    }
    area_ = across(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  }

  [[nodiscard]] double low(glm::length_t i) const {
    return std::min({corners_[0][i], corners_[1][i], corners_[2][i]});
  }
  [[nodiscard]] double high(glm::length_t i) const {
    return std::max({corners_[0][i], corners_[1][i], corners_[2][i]});
  }

  /// Returns where the line through the point along the axis meets it.
  [[nodiscard]] std::optional<double> meets(const Vec3& point) const {
    if (area_ == 0.0) {
      return std::nullopt;
    }
    const Vec3 from = point - corners_[0];
    const double u = across(from, corners_[2] - corners_[0]) / area_;
    const double v = across(corners_[1] - corners_[0], from) / area_;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) {
      return std::nullopt;
    }
    return corners_[0][axis_] * (1.0 - u - v) + corners_[1][axis_] * u + corners_[2][axis_] * v;
  }

private:
  [[nodiscard]] double across(const Vec3& p, const Vec3& q) const { return p[a_] * q[b_] - p[b_] * q[a_]; }

  std::array<Vec3, 3> corners_{};
  glm::length_t axis_;
  glm::length_t a_;
  glm::length_t b_;
  double area_ = 0.0;
};

} // namespace stretch::skinning

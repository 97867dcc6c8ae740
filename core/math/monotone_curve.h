#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch {

/// The slope at a point between its neighbours with which a curve through them does not overshoot: the
/// Fritsch-Butland weighted harmonic mean of both secants, 0 at an extreme. x strictly increasing.
[[nodiscard]] double monotoneSlope(const Vec2& before, const Vec2& at, const Vec2& after);

/// A curve through points of increasing x that never overshoots: cubic Hermite pieces whose slopes are 0 at
/// both ends and those of monotoneSlope inside (F. N. Fritsch, J.
/// Butland, "A method for constructing local monotone piecewise cubic interpolants", 1984).
/// Monotone wherever the points are.
class MonotoneCurve {
public:
  /// At least two points, x strictly increasing.
  explicit MonotoneCurve(std::vector<Vec2> points);

  /// Held before the first and after the last point.
  [[nodiscard]] double at(double x) const;

private:
  std::vector<Vec2> points_;
  std::vector<double> slopes_;
};

} // namespace stretch

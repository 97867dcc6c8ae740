#include "core/math/monotone_curve.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"

namespace stretch {

double monotoneSlope(const Vec2& before, const Vec2& at, const Vec2& after) {
  const double h0 = at.x - before.x;
  const double h1 = after.x - at.x;
  const double secant0 = (at.y - before.y) / h0;
  const double secant1 = (after.y - at.y) / h1;
  if (secant0 * secant1 <= 0.0) {
    return 0.0;
  }
  return 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / secant0 + (h1 + 2.0 * h0) / secant1);
}

MonotoneCurve::MonotoneCurve(std::vector<Vec2> points)
    : points_(std::move(points)), slopes_(points_.size(), 0.0) {
  check(points_.size() >= 2, "a monotone curve needs two points");
  for (std::size_t i = 1; i < points_.size(); ++i) {
    check(points_[i].x > points_[i - 1].x, "the points of a monotone curve have increasing x");
  }
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    slopes_[i] = monotoneSlope(points_[i - 1], points_[i], points_[i + 1]);
  }
}

double MonotoneCurve::at(double x) const {
  if (x <= points_.front().x) {
    return points_.front().y;
  }
  if (x >= points_.back().x) {
    return points_.back().y;
  }
  const auto next = std::upper_bound(points_.begin(), points_.end(), x,
                                     [](double value, const Vec2& p) { return value < p.x; });
  const auto i = static_cast<std::size_t>(next - points_.begin()) - 1;
  const double h = points_[i + 1].x - points_[i].x;
  const double t = (x - points_[i].x) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * points_[i].y + (t3 - 2 * t2 + t) * h * slopes_[i] +
         (3 * t2 - 2 * t3) * points_[i + 1].y + (t3 - t2) * h * slopes_[i + 1];
}

} // namespace stretch

#pragma once

#include <vector>

namespace stretch::ui {

/// A range of values laid out along one direction of the screen; for vertical axes give `pixelStart` the
/// lower edge.
struct Axis {
  double start = 0.0; ///< Value at pixelStart.
  double end = 1.0;   ///< Value at pixelEnd; differs from start.
  float pixelStart = 0.0F;
  float pixelEnd = 1.0F;

  [[nodiscard]] float toPixel(double value) const;
  [[nodiscard]] double toValue(float pixel) const;
  [[nodiscard]] double valuesPerPixel() const;
};

/// The round step (1, 2, 5 times a power of ten) at which marks are at least `pixels` apart. Whole steps only
/// when `wholeNumbers` is set.
[[nodiscard]] double markStep(const Axis& axis, float pixels, bool wholeNumbers);

/// Multiples of the step within the axis, at most a few hundred.
[[nodiscard]] std::vector<double> marks(const Axis& axis, double step);

struct Span {
  double start = 0.0;
  double end = 1.0;
};

/// Scaled about a value; the width stays within [smallest, largest].
[[nodiscard]] Span zoomed(const Span& span, double about, double factor, double smallest, double largest);

} // namespace stretch::ui

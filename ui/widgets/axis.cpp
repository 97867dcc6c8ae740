#include "ui/widgets/axis.h"

#include <algorithm>
#include <cmath>

namespace stretch::ui {

float Axis::toPixel(double value) const {
  const double part = (value - start) / (end - start);
  return pixelStart + static_cast<float>(part * static_cast<double>(pixelEnd - pixelStart));
}

double Axis::toValue(float pixel) const {
  const double part = static_cast<double>(pixel - pixelStart) / static_cast<double>(pixelEnd - pixelStart);
  return start + part * (end - start);
}

double Axis::valuesPerPixel() const {
  return std::abs((end - start) / std::max(1.0, static_cast<double>(std::abs(pixelEnd - pixelStart))));
}

double markStep(const Axis& axis, float pixels, bool wholeNumbers) {
  const double wanted = std::max(axis.valuesPerPixel() * static_cast<double>(pixels), 1e-9);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = power * 10.0;
  for (const double factor : {5.0, 2.0, 1.0}) {
    step = power * factor >= wanted ? power * factor : step;
  }
  return wholeNumbers ? std::max(1.0, std::round(step)) : step;
}

std::vector<double> marks(const Axis& axis, double step) {
  constexpr int most = 500;
  const double low = std::min(axis.start, axis.end);
  const double high = std::max(axis.start, axis.end);
  std::vector<double> values;
  const double first = std::ceil(low / step - 1e-9);
  for (int i = 0; i < most && (first + i) * step <= high + step * 1e-9; ++i) {
    values.push_back((first + i) * step);
  }
  return values;
}

Span zoomed(const Span& span, double about, double factor, double smallest, double largest) {
  const double width = std::clamp((span.end - span.start) * factor, smallest, largest);
  const double part = (about - span.start) / std::max(span.end - span.start, 1e-12);
  const double start = about - part * width;
  return {start, start + width};
}

} // namespace stretch::ui

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stretch {

/// Middle of the values in order, the upper one of two; `otherwise` where there are none. No value may be
/// NaN.
[[nodiscard]] inline double medianOf(std::vector<double> values, double otherwise) {
  if (values.empty()) {
    return otherwise;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace stretch

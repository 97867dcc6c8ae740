#pragma once

#include <algorithm>
#include <cmath>

namespace stretch::test {

/// Largest absolute difference of any element of two square matrices.
template <typename Matrix>
[[nodiscard]] double largestDifference(const Matrix& a, const Matrix& b) {
  double largest = 0.0;
  for (std::size_t column = 0; column < a.length(); ++column) {
    for (std::size_t row = 0; row < a.length(); ++row) {
      largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    }
  }
  return largest;
}

} // namespace stretch::test

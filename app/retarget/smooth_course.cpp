#include "app/retarget/smooth_course.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace stretch::app {

std::vector<double> smoothCourse(const std::vector<double>& wanted, const std::vector<double>& confidences,
                                 double stiffness) {
  const std::size_t count = wanted.size();
  // Lower band of the symmetric matrix: each row's diagonal, and its entries one and two columns before it.
  std::vector<std::array<double, 3>> rows(count);
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    rows[i] = {confidences[i], 0.0, 0.0};
    values[i] = confidences[i] * wanted[i];
  }
  constexpr std::array<double, 3> difference{1.0, -2.0, 1.0};
  for (std::size_t i = 0; i + 2 < count; ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        rows[i + a][a - b] += stiffness * difference[a] * difference[b];
      }
    }
  }
  // L D L^T of the band, then the two triangular systems.
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t back = std::min<std::size_t>(i, 2); back > 0; --back) {
      const std::size_t j = i - back;
      if (back == 1 && i >= 2) {
        rows[i][1] -= rows[i][2] * rows[j][1] * rows[i - 2][0];
      }
      rows[i][back] /= rows[j][0];
    }
    for (std::size_t back = 1; back <= std::min<std::size_t>(i, 2); ++back) {
      rows[i][0] -= rows[i][back] * rows[i][back] * rows[i - back][0];
      values[i] -= rows[i][back] * values[i - back];
    }
  }
  for (std::size_t i = count; i-- > 0;) {
    values[i] /= rows[i][0];
    for (std::size_t ahead = 1; ahead <= 2 && i + ahead < count; ++ahead) {
      values[i] -= rows[i + ahead][ahead] * values[i + ahead];
    }
  }
  return values;
}

} // namespace stretch::app

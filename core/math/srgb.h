#pragma once

#include <cmath>

namespace stretch {

/// One channel of a colour, 0..1, from sRGB to linear light (IEC 61966-2-1).
template <typename Real>
[[nodiscard]] Real linearFromSrgb(Real encoded) {
  return encoded <= Real(0.04045) ? encoded / Real(12.92)
                                  : std::pow((encoded + Real(0.055)) / Real(1.055), Real(2.4));
}

/// The way back.
template <typename Real>
[[nodiscard]] Real srgbFromLinear(Real linear) {
  return linear <= Real(0.0031308) ? linear * Real(12.92)
                                   : Real(1.055) * std::pow(linear, Real(1) / Real(2.4)) - Real(0.055);
}

} // namespace stretch

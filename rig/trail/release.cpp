#include "rig/trail/release.h"

#include <algorithm>

namespace stretch::rig {

namespace {

double decay(double u, double swing) {
  const double rest = 1.0 - u;
  return 1.0 - smoothstep(u) - swing * u * u * rest * rest;
}

double lowest(double swing) {
  double least = 0.0;
  constexpr int steps = 200;
  for (int i = 1; i < steps; ++i) {
    least = std::min(least, decay(static_cast<double>(i) / steps, swing));
  }
  return least;
}

// The factor whose decay dips to -overshoot, by bisection: the dip deepens with the factor.
double swingFor(double overshoot) {
  double low = 0.0;
  double high = 64.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (lowest(middle) > -overshoot ? low : high) = middle;
  }
  return high;
}

} // namespace

double smoothstep(double u) {
  const double t = std::clamp(u, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Release::Release(double seconds, double overshoot, double lingerSeconds)
    : seconds_(std::max(0.0, seconds)), lingerSeconds_(std::clamp(lingerSeconds, 0.0, seconds_)),
      swing_(overshoot > 0.0 ? swingFor(std::min(overshoot, 1.0)) : 0.0) {}

double Release::at(double secondsPastTip) const {
  if (secondsPastTip <= lingerSeconds_) {
    return 1.0;
  }
  return secondsPastTip < seconds_
             ? decay((secondsPastTip - lingerSeconds_) / (seconds_ - lingerSeconds_), swing_)
             : 0.0;
}

} // namespace stretch::rig

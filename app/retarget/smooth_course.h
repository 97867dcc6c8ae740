#pragma once

#include <vector>

namespace stretch::app {

/// A curve over frames that is near the wanted values where confidence is high, and bends as little as it
/// can: the least sum of confidence (x - wanted)^2 + stiffness (second difference of x)^2 (Whittaker 1923).
/// As many confidences as values, each > 0; `stiffness` >= 0.
[[nodiscard]] std::vector<double> smoothCourse(const std::vector<double>& wanted,
                                               const std::vector<double>& confidences, double stiffness);

} // namespace stretch::app

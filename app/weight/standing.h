#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/weight/sample_clip.h"

namespace stretch::app {

/// How much the legs of a clip stand on the ground and carry, sample by sample.
struct Standing {
  std::vector<std::string> legs;
  std::vector<std::vector<double>> planted; ///< 0..1.
  std::vector<std::vector<double>> kept;    ///< How much the foot keeps its place, 0..1: 1 where it touches.
  std::vector<std::vector<double>> shares;  ///< Shares of the body above, 0..1.

  /// `legs.size()` for a limb that is not a leg.
  [[nodiscard]] std::size_t indexOf(const std::string& limb) const {
    return static_cast<std::size_t>(std::find(legs.begin(), legs.end(), limb) - legs.begin());
  }
};

/// A foot stands when its lowest joint is near the lowest place that any foot gets to against gravity (upOf)
/// and does not shoot up or down: on a clip that walks in place it slides, and at a landing the body brakes
/// while the foot still comes down. It touches the ground wherever it is that low. Without a leg nothing
/// stands.
[[nodiscard]] Standing standingOf(const SampledClip& sampled, double metresPerUnit);

} // namespace stretch::app

#pragma once

#include <cstddef>
#include <vector>

#include "skinning/locate/standing_body.h"

namespace stretch::skinning {

/// The middle of a leg in one layer.
struct LegSection {
  double height = 0.0;
  Vec3 middle{0.0};
  double area = 0.0;
  double front = 0.0; ///< How far it reaches forward of its middle.
  double back = 0.0;
};

/// Both legs from the ground to where they meet.
struct LegLines {
  std::vector<LegSection> right; ///< The side of -X.
  std::vector<LegSection> left;
  double crotch = 0.0;     ///< Height of the first layer where the two are one.
  std::vector<bool> isLeg; ///< For each cell of the body.

  [[nodiscard]] bool found() const { return !left.empty() && !right.empty(); }
};

[[nodiscard]] LegLines legLines(const StandingBody& body);

/// On how many legs the body stands: parts of the lowest layers that do not touch each other, without what is
/// thin beside the thickest. 0 for a body without such layers.
[[nodiscard]] std::size_t legsUnder(const StandingBody& body);

} // namespace stretch::skinning

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "skinning/locate/leg_lines.h"

namespace stretch::skinning {

/// A section of an arm across its way.
struct ArmSection {
  double way = 0.0; ///< From the tip of the hand.
  Vec3 middle{0.0};
  double radius = 0.0; ///< Radius of a disc as large as the section.
};

/// An arm from the tip of the hand to the middle of the body.
struct ArmLine {
  std::vector<ArmSection> sections; ///< By the way inside the body.
  double way = 0.0;                 ///< From the middle of the body to the tip.
  /// Where the arm is a piece of its own: the way to where it ends. Else 0.
  double ownPiece = 0.0;
  std::vector<std::pair<std::uint32_t, double>> cells; ///< With their ways from the tip.
};

/// For each cell the way inside the body from its middle plane, legs left out: a tail lies in it.
[[nodiscard]] std::vector<double> waysFromMiddle(const StandingBody& body, const LegLines& legs);

/// `side`: 1 for +X. The tip is what is farthest from the middle of the body (waysFromMiddle), legs left
/// out; `longest`: no farther than that, as what an arm holds is no part of it.
[[nodiscard]] ArmLine armLine(const StandingBody& body, const LegLines& legs,
                              const std::vector<double>& fromMiddle, double side, double longest);

/// Sections at right angles to the line that an arm follows up to `way`. Empty where it bends too much for
/// one.
[[nodiscard]] std::vector<ArmSection> straightSections(const StandingBody& body, const ArmLine& arm,
                                                       double way);

} // namespace stretch::skinning

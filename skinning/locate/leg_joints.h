#pragma once

#include "skinning/locate/leg_lines.h"
#include "skinning/locate/placed.h"

namespace stretch::skinning {

struct LegJoints {
  Placed hip;
  Placed knee;
  Placed ankle;
  Placed toes;
};

/// How far the feet reach forward of the shins, less how far they reach backward: above 0 where they point
/// to +Z. 0 without legs.
[[nodiscard]] double facingOf(const LegLines& legs);

/// Whether both legs are the same all along their upper part, as boxes and tubes are: they turn at their
/// tops.
[[nodiscard]] bool areBoxes(const LegLines& legs);

/// Joints on the sections of a leg, the hip at a given height; `facing`: 1 where the body faces +Z, else -1.
[[nodiscard]] LegJoints legJoints(const std::vector<LegSection>& leg, double hipHeight, double facing);

/// A leg where none shows, by the proportions of a person. `side`: 1 for +X.
[[nodiscard]] LegJoints guessedLeg(double hipHeight, double side, double facing);

} // namespace stretch::skinning

#pragma once

#include "skinning/locate/placed.h"
#include "skinning/locate/standing_body.h"

namespace stretch::skinning {

struct TrunkJoints {
  Placed hips;
  Placed neck;
  Placed head;
};

/// The neck is narrow above the shoulders. `halfWidth`: how far from the middle the trunk reaches.
[[nodiscard]] TrunkJoints trunkJoints(const StandingBody& body, double crotch, double shoulderHeight,
                                      double halfWidth);

/// Height of the hip joints over the crotch; where the head is as small as a person's, the neck counts too.
[[nodiscard]] double hipHeightOf(double crotch, double neckHeight);

} // namespace stretch::skinning

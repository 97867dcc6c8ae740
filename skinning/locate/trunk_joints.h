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

/// Over what is not a leg: how deep the body is, front to back, for its height, as spreads of its cells.
/// Below 1 for what stands upright as a person does, above for a trunk that lies, as a bird's.
[[nodiscard]] double depthForHeight(const StandingBody& body, double crotch, double halfWidth);

/// Height of the hip joints over the crotch; where the head is as small as a person's, the neck counts too. A
/// crotch that is too high for one, as between the bare bones of a pelvis, does not count.
[[nodiscard]] double hipHeightOf(double crotch, double neckHeight);

} // namespace stretch::skinning

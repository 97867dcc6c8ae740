#pragma once

#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/reach/bind_places.h"
#include "rig/reach/limb_topology.h"

namespace stretch::rig {

/// Points that a foot rolls about, in the space of the foot's joint (docs/controllers.md, Curl and roll).
struct FootRoll {
  Vec3 ball{0.0};
  Vec3 heel{0.0};
  Vec3 axis{0.0}; ///< Unit: a positive turn about it lifts the heel. Zero: nothing to roll about.
  NodeIndex toes; ///< The joint at the ball, which stays flat while the heel lifts; -1: none.
};

[[nodiscard]] FootRoll footRoll(const Scene& scene, const Limb& leg, const LimbTopology& topology,
                                const BindPlaces& places);

/// Angle of a roll from -1 to 1, radians: above 0 about the ball, below about the heel.
[[nodiscard]] double rollRadians(double roll);

} // namespace stretch::rig

#pragma once

#include <array>

#include "app/auto/planned_trail.h"
#include "app/auto/whole_check.h"

namespace stretch::app {

inline constexpr double leastExcess = 0.05; ///< Change of a scale: less is not seen.
inline constexpr double lowered = 0.7; ///< Share that is left of an exaggeration of which there has to be
                                       ///< less.
inline constexpr std::array<bool, 3> allAxes{true, true, true};
inline constexpr std::array<bool, 3> levelAxes{true, false, true};

/// How much longer or shorter the limb of a trail is to become, in lengths of itself. A foot's lift is none.
[[nodiscard]] double excessOf(const ClipGround& ground, const PlannedTrail& planned);

/// Lets the limb come back at once, where it was to hold its pose first; false where it was not, or holds it
/// over a loop's seam.
bool letGo(const ClipGround& ground, rig::TrailSettings& settings);

/// Does one thing, the least that is left to try, against a fault that the trail shows together with the
/// others of the plan: it comes back at once, goes along the ground, lifts its foot, starts when its foot
/// stands no more, keeps still at the seam, or gets less; left out where nothing is to be seen of it any
/// more.
void lower(const ClipGround& ground, AutoPlan& plan, const Fault& fault);

} // namespace stretch::app

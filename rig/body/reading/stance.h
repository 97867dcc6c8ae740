#pragma once

#include <vector>

#include "rig/body/reading/biped_reading.h"
#include "rig/body/reading/plan_parts.h"

namespace stretch::rig::body {

/// How many legs a body stands on: what branches off the middle of the body, is no accessory, rises well
/// above the ground and reaches it, counted in pairs. The arms of an upright body are no legs however low
/// they reach, nor is what hangs beside its legs (coat tails). 0 where
/// nothing reaches the ground.
[[nodiscard]] int standingLegs(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading);

/// Whether names call every pair that stands legs.
[[nodiscard]] bool areLegsNamed(const std::vector<KindredPair>& pairs);

/// Makes no legs of what stands beside two pairs or more that are called so, and is called no limb: a
/// blanket.
void dropStrayLegs(std::vector<KindredPair>& pairs);

/// Whether a pair is none of the limbs of a beast whose head and four legs or more are called so: what it
/// draws or wears, and no name calls a limb.
[[nodiscard]] bool isBesideNamedLegs(const BodyView& view, const PlanParts& parts, const KindredPair& pair);

/// Along which a beast stands whose feet are on no level floor, most likely first: square to the normal of
/// its mirror plane, and leaning from that fore and aft by up to 13 degrees. None where the plane lies.
[[nodiscard]] std::vector<Vec3> leaningUps(const MirrorPlane& plane);

/// Along which a body may stand that does not stand along +Y: the other axes that its mirror plane allows.
[[nodiscard]] std::vector<Vec3> otherUps(const MirrorPlane& plane);

} // namespace stretch::rig::body

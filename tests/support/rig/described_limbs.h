#pragma once

#include <string>
#include <vector>

#include "rig/body/reading/detection.h"
#include "tests/support/rig/synthetic_biped.h"

namespace stretch::test {

/// The limb of a kind; null where it was not found.
[[nodiscard]] const rig::Limb* findLimb(const rig::Body& biped, const rig::LimbPlace& place);

/// The key of a node; "estimated" for one that was made from no key.
[[nodiscard]] std::string keyOf(const BuiltBiped& built, NodeIndex node);

/// Keys of a limb's joints and of its end: "upperArm.l foreArm.l -> hand.l"; "-> estimated" without an end
/// joint, "none" without the limb.
[[nodiscard]] std::string describe(const BuiltBiped& built, const rig::Body& biped,
                                   const rig::LimbPlace& place);

/// Checks that the body is a biped whose arms and legs are found as in any biped that SyntheticBiped makes.
void checkArmsAndLegs(const BuiltBiped& built, const rig::Body& biped);

/// World position of a limb's end in the bind pose.
[[nodiscard]] Vec3 endOf(const Scene& scene, const rig::Limb& limb);

/// The angle at the middle one of the first three points of a limb, radians.
[[nodiscard]] double innerAngle(const std::vector<Vec3>& points);

/// Whether one of the body's warnings has these words.
[[nodiscard]] bool warnsOf(const rig::Body& body, const std::string& words);

} // namespace stretch::test

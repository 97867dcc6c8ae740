#pragma once

#include <string>

#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"
#include "rig/body/reading/plan_reading.h"

namespace stretch::rig::body {

/// Says that the plan and its limbs are a guess.
void doubt(Body& result, const std::string& why);

/// Whether a beast's legs may be the arms and legs of a person: some are called arms and not all go down, as
/// of one who lies, or upper arms are named and the others begin level, as the thighs of one who sits.
/// Shoulder blades and collar bones are named in beasts as well, and so they tell nothing beside a tail.
[[nodiscard]] bool mayLie(const Scene& scene, const BindPose& bindPose, const PlanReading& reading);

/// Whether what was read as a bird may be a person who lies or bows: names call its arms or wings upper arms,
/// and it has no tail that is called one or is longer than an arm.
[[nodiscard]] bool mayBePerson(const Scene& scene, const PlanReading& reading);

/// A reading of a body that stands along `up` (world, unit), which is not +Y: less sure, and asked about.
[[nodiscard]] PlanReading turnedOver(PlanReading reading, const Vec3& up);

/// Whether a body that no name tells has wings or arms beside its legs: a centaur's, for all that is known.
[[nodiscard]] bool hasGuessedWings(const PlanReading& reading);

/// Whether names call legs of what stands on two or six of them arms: its own may not have been found, or
/// they are a centaur's arms. The front legs of what stands on four are called arms by some programs.
[[nodiscard]] bool hasArmsForLegs(const Scene& scene, const PlanReading& reading);

/// Whether a trunk, neck or tail goes along a joint of an arm, as that of a person may be who crouches with
/// it held out.
[[nodiscard]] bool hasArmInMiddle(const PlanReading& reading, const std::vector<Limb>& ofPerson);

/// Whether what was read as a serpent may be something else: its row of joints goes through what is called a
/// leg, an arm, a wing or a horn; or no name tells of a tail or fins, and it stands, or is less than half of
/// the body and has no head by name.
[[nodiscard]] bool mayBeNoSerpent(const Scene& scene, const BindPose& bindPose, const PlanReading& reading);

/// Whether a biped's trunk lies while its arms and legs go down, as those of a beast do.
[[nodiscard]] bool standsOnFour(const BindPose& bindPose, const Body& body, const Vec3& bodyUp);

/// Whether names call what was read as a biped's arms legs, as of a beast that stands on its hind legs or
/// whose file lost which way is up.
[[nodiscard]] bool hasLegsForArms(const Scene& scene, const Body& body);

/// Whether a biped has no arms, and names call joints of its file wings.
[[nodiscard]] bool hasWingsForArms(const Scene& scene, const Body& body);

/// Tells the first joints of rows that are called arms, legs, wings, fins or tails, move a mesh away from the
/// limbs and are in none of them, nor in the trunk: the plan has no place for them, or no reading found them.
/// So is a neck that is called one.
void tellLimbsLeftOut(const Scene& scene, const BindPose& bindPose, Body& body);

/// Whether the spine of a biped stands across its legs, as a bird's does. `legsReach`: from hips to feet.
[[nodiscard]] bool leansAsABird(const BindPose& bindPose, const Body& body, const Vec3& legsReach);

} // namespace stretch::rig::body

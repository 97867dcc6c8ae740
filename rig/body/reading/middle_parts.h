#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig/body/reading/plan_parts.h"

namespace stretch::rig::body {

/// The joint that both limbs of a pair hang from, whatever one of them has between.
[[nodiscard]] int carrierOf(const BodyView& view, const ExtremityPair& pair);

/// Whether a limb hangs from a joint or from one below it; `countsChains`: one of no kind yet as well.
[[nodiscard]] bool carriesLimb(const BodyView& view, const PlanParts& parts, int joint,
                               bool countsChains = true);

/// The trunk of a body that is rooted before its hind legs: from the joint at which it leaves the row of the
/// head to the one that they hang from. Empty where that is of the row itself.
[[nodiscard]] std::vector<int> trunkBehind(const BodyView& view, const PlanParts& parts);

/// Whether a joint's name says that it is one of a tail.
[[nodiscard]] bool isCalledTail(const BodyView& view, int joint);

/// How many joints a row that is called a tail has before its first one that is called so, or that has lost
/// its name: they are the rump's. 0 where these are more than two: then a late joint alone has the name.
[[nodiscard]] std::size_t jointsOfRump(const BodyView& view, const std::vector<int>& tail);

/// A row of the middle that goes back from the trunk, without the joints that carry legs, or that comes to it
/// from behind (see hangsFromTip).
[[nodiscard]] std::optional<Extremity> tailOf(const BodyView& view, const PlanParts& parts);

/// Whether the head is named and stands aside from the middle of the legs, not but above it, so that it tells
/// the front: a machine's may be the joint that all legs hang from. World space; `up` is a unit vector.
[[nodiscard]] bool isHeadAside(const BodyView& view, const Axis& axis, const Vec3& middleOfLegs,
                               const Vec3& up);

/// Whether the joints of a tail hang from its tip: it starts from nothing and comes up to the hips.
[[nodiscard]] bool hangsFromTip(const BodyView& view, const Axis& axis, const Extremity& tail);

/// Whether a joint of a body that stands on legs moves nothing itself and lies on the ground, as a root does;
/// not of a body without vertices.
[[nodiscard]] bool isRootOnFloor(const BodyView& view, const PlanParts& parts, int joint, const Vec3& up);

/// The question whether the head is at the other end of a body, if no name tells of it and another row of the
/// middle ends far higher than the head stands; none otherwise.
[[nodiscard]] std::optional<std::string> doubtOfHead(const BodyView& view, const PlanParts& parts,
                                                     const Vec3& up);

/// From which on a joint's name tells its role clearly.
inline constexpr double clearRole = 0.5;

/// Whether a joint is named as one of a neck.
[[nodiscard]] bool isNeck(const BodyView& view, int joint);

/// Largest extent of the vertices that follow a joint, world units; 0 without any.
[[nodiscard]] double bulk(const BodyView& view, int joint);

/// Lets the row of the head end at the joint that is named head where that hangs beside it: a row may go on
/// into a jaw.
void endAtHeadBeside(const BodyView& view, PlanParts& parts);

/// Reads a whole row as neck and head, as bodies in pieces have it, and what leads to hind legs as the trunk.
void takeNeckAlone(const BodyView& view, PlanParts& parts);

} // namespace stretch::rig::body

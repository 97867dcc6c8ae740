#pragma once

#include <optional>
#include <vector>

#include "rig/body/reading/extremities.h"

namespace stretch::rig::body {

/// An end made for a limb whose last joint has no wrist, ankle or tip below it.
struct EstimatedEnd {
  Vec3 position{0.0}; ///< World, bind pose.
  bool fromPalms = false;
};

/// The mean of the palm joints that hang from `last` (of all its children where at least three fan out
/// unnamed), else the far end of the vertices that follow it, along the line from the joint to their centre.
/// Nothing without either.
[[nodiscard]] std::optional<EstimatedEnd> estimateEnd(const BodyView& view, int last);

/// A row of one joint that is called a leg, an arm, a wing or a fin, as models of blocks have them, with its
/// estimated end as a second point; every other row as it is.
[[nodiscard]] Extremity withEstimatedEnd(const BodyView& view, Extremity row);

/// Takes single joints that are called legs, arms, wings or fins out of the rows of both sides where a row of
/// several joints is called the same: beside these one alone is a plate or a feather.
void dropLoneJoints(std::vector<Extremity>& left, std::vector<Extremity>& right);

/// Whether fingers or palms start at a joint: three children or more, or two that are named palms.
[[nodiscard]] bool isFan(const BodyView& view, int candidate);

/// Which point of a row that stands on the ground, at the height `floor` along `up`, ends the leg: where it
/// meets the ground, or its foot that hangs elsewhere; what lies beyond are toes.
[[nodiscard]] std::size_t endOfLeg(const BodyView& view, const Extremity& leg, const Vec3& up, double floor);

} // namespace stretch::rig::body

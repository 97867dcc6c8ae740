#pragma once

#include <string>
#include <string_view>

#include "rig/body/reading/detection.h"
#include "rig/plan/body_plan.h"

namespace stretch::rig {

/// The plan of a body; `other` where its id is none of a plan.
[[nodiscard]] const BodyPlan& planOf(const Body& body);

/// The limbs of a plan that the user chose: what of it the character has. `other`: every chain between
/// branchings. Its height as detectBody has it.
[[nodiscard]] Body bodyAsPlan(const Scene& scene, const BodyPlan& plan, const Clip* clip = nullptr);

/// Says of limbs that their plan has led by the head whether that is at their first joint. `bindWorlds`: of
/// all nodes in the bind pose. Without a known head they are led by their ends, as all others are.
void setLeadingEnds(const std::vector<Mat4>& bindWorlds, Body& body);

/// "the character is a quadruped and has no left-arm; it has front-left-leg, ...": why the body has no such
/// limb; empty for a biped, and where the plan has it.
[[nodiscard]] std::string whyNoLimb(const Body& body, std::string_view id);

} // namespace stretch::rig

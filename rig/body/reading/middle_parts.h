#pragma once

#include <optional>
#include <vector>

#include "rig/body/reading/plan_parts.h"

namespace stretch::rig::body {

/// The joint that both limbs of a pair hang from, whatever one of them has between.
[[nodiscard]] int carrierOf(const BodyView& view, const ExtremityPair& pair);

/// The trunk of a body that is rooted before its hind legs: from the joint at which it leaves the row of the
/// head to the one that they hang from. Empty where that is of the row itself.
[[nodiscard]] std::vector<int> trunkBehind(const BodyView& view, const PlanParts& parts);

/// A row of the middle that goes back from the trunk, without the joints that carry legs.
[[nodiscard]] std::optional<Extremity> tailOf(const BodyView& view, const PlanParts& parts);

} // namespace stretch::rig::body

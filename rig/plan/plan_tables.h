#pragma once

#include <vector>

#include "rig/plan/body_plan.h"

namespace stretch::rig {

/// The body plans that there are: a new one is added here, and nowhere else (docs/body_plans.md).
[[nodiscard]] std::vector<BodyPlan> planTables();

} // namespace stretch::rig

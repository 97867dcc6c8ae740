#include "rig/plan/body_plan.h"

#include <algorithm>

#include "rig/plan/plan_tables.h"

namespace stretch::rig {

const std::vector<BodyPlan>& bodyPlans() {
  static const std::vector<BodyPlan> plans = planTables();
  return plans;
}

std::string planIds() {
  std::string ids;
  for (const BodyPlan& plan : bodyPlans()) {
    ids += (ids.empty() ? "" : ", ") + plan.id;
  }
  return ids;
}

const BodyPlan* planNamed(std::string_view id) {
  const auto found = std::ranges::find(bodyPlans(), id, &BodyPlan::id);
  return found == bodyPlans().end() ? nullptr : &*found;
}

const PlannedLimb* plannedLimb(const BodyPlan& plan, std::string_view id) {
  const auto found = std::ranges::find(plan.limbs, id, &PlannedLimb::id);
  return found == plan.limbs.end() ? nullptr : &*found;
}

const PlannedLimb* plannedLimb(const BodyPlan& plan, const LimbPlace& place) {
  const auto found = std::ranges::find(plan.limbs, place, &PlannedLimb::place);
  return found == plan.limbs.end() ? nullptr : &*found;
}

LimbPlace placeInPlan(const BodyPlan& plan, std::string_view id) {
  const PlannedLimb* const limb = plannedLimb(plan, id);
  return limb != nullptr ? limb->place : LimbPlace{};
}

} // namespace stretch::rig

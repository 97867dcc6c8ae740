#include "rig/body/planned_body.h"

namespace stretch::rig {

const BodyPlan& planOf(const Biped& body) {
  const BodyPlan* const plan = planNamed(body.plan);
  return plan != nullptr ? *plan : bodyPlans().back();
}

std::string whyNoLimb(const Biped& body, std::string_view id) {
  const BodyPlan& plan = planOf(body);
  if (plannedLimb(plan, id) != nullptr || plan.id == "biped") {
    return {};
  }
  std::string has;
  for (const Limb& limb : body.limbs) {
    has += (has.empty() ? "" : ", ") + limb.id;
  }
  return "the character is " + plan.title + " and has no " + std::string(id) +
         (has.empty() ? "" : "; it has " + has);
}

} // namespace stretch::rig

#include "rig/body/reading/planned_body.h"

#include <glm/geometric.hpp>

namespace stretch::rig {

const BodyPlan& planOf(const Body& body) {
  const BodyPlan* const plan = planNamed(body.plan);
  return plan != nullptr ? *plan : bodyPlans().back();
}

void setLeadingEnds(const std::vector<Mat4>& bindWorlds, Body& body) {
  for (Limb& limb : body.limbs) {
    const PlannedLimb* const planned = plannedLimb(planOf(body), limb);
    limb.ledByFirst = false;
    if (planned == nullptr || !planned->ledByHead || !body.head.exists()) {
      continue;
    }
    const Vec3 head = positionOf(bindWorlds[at(body.head)]);
    const std::vector<Vec3> points = limbPoints(limb, bindWorlds);
    limb.ledByFirst = glm::distance(points.front(), head) < glm::distance(points.back(), head);
  }
}

std::string whyNoLimb(const Body& body, std::string_view id) {
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

// The figures of all body plans, and how their limbs move, as they were looked at.
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rig/plan/body_plan.h"
#include "tests/support/recorded.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

std::string textOf(const PlannedLimb& limb) {
  std::string text = fmt::format("  {} {}{}{}\n", limb.id, limbName(limb.place), limb.usual ? " usual" : "",
                                 limb.ledByHead ? " led by its head" : "");
  for (const FigureBone& bone : limb.bones) {
    text += fmt::format("    from {:.3f} {:.3f} of {:.3f} to {:.3f} {:.3f} of {:.3f}\n", bone.fromX,
                        bone.fromY, bone.fromRadius, bone.toX, bone.toY, bone.toRadius);
  }
  const LimbManner& manner = limb.manner;
  return text +
         fmt::format("    end {:.3f} {:.3f} , key {:.3f} {:.3f}\n", limb.end.x, limb.end.y, limb.key.x,
                     limb.key.y) +
         fmt::format("    {}{}overshoot {:.3f} stiffness {:.3f} damping {:.3f}\n",
                     manner.stands ? "stands " : "", manner.turnEnd ? "turns its end " : "", manner.overshoot,
                     manner.stiffness, manner.damping);
}

} // namespace

TEST_CASE("The figure of each body plan and the manner of its limbs are as they were looked at") {
  std::string text;
  for (const BodyPlan& plan : bodyPlans()) {
    text += fmt::format("{} , {} , {} legs , seen from {}\n", plan.id, plan.title, plan.legs,
                        plan.view == FigureView::front ? "in front" : "above");
    for (const PlannedLimb& limb : plan.limbs) {
      text += textOf(limb);
    }
    for (const PlannedController& controller : plan.controllers) {
      text += fmt::format("  {} at {:.3f} {:.3f}\n", controller.id, controller.place.x, controller.place.y);
    }
  }
  test::compareWithRecord("body_plans", text, 1e-6);
}

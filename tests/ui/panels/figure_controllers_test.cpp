// Where controllers stand on the figure of a body.
#include <algorithm>

#include <catch2/catch.hpp>

#include "rig/plan/body_plan.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;

TEST_CASE("Of a figure that says no place for them, a spine's controllers stand at its ends and half-way") {
  int placed = 0;
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    const auto spine = std::ranges::find(plan.limbs, "spine", &rig::PlannedLimb::id);
    if (spine == plan.limbs.end() ||
        std::ranges::find(plan.controllers, "spine-low", &rig::PlannedController::id) !=
            plan.controllers.end()) {
      continue;
    }
    CAPTURE(plan.id);
    app::Document document = test::PanelDriver::bundledCharacter();
    document.body.plan = plan.id;
    test::PanelDriver driver(document);
    const ImVec2 top = driver.centreOf("limb/spine-top");
    const ImVec2 middle = driver.centreOf("limb/spine-mid");
    const ImVec2 low = driver.centreOf("limb/spine-low");
    const rig::FigureBone& first = spine->bones.front();
    const rig::FigureBone& last = spine->bones.back();
    const rig::FigureBone& inner = spine->bones[spine->bones.size() / 2];
    const bool isOne = spine->bones.size() == 1;
    const float middleX = isOne ? 0.5F * (first.fromX + first.toX) : inner.fromX;
    const float middleY = isOne ? 0.5F * (first.fromY + first.toY) : inner.fromY;
    const float scale = (low.y - top.y) / (last.toY - first.fromY); // Pixels for each unit of the figure.
    REQUIRE(scale > 0.1F);
    CHECK(low.x - top.x == Approx(scale * (last.toX - first.fromX)).margin(0.5));
    CHECK(middle.x - top.x == Approx(scale * (middleX - first.fromX)).margin(0.5));
    CHECK(middle.y - top.y == Approx(scale * (middleY - first.fromY)).margin(0.5));
    ++placed;
  }
  CHECK(placed >= 3);
}

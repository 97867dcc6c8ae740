// The joints of all plans of locators, as they were looked at.
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rig/body/locators/locator_plans.h"
#include "tests/support/recorded.h"

using namespace stretch;
using namespace stretch::rig;

TEST_CASE("The joints of each plan of locators are as they were looked at") {
  std::string text;
  for (const LocatorPlan& plan : locatorPlans()) {
    text += fmt::format("{}{}\n", plan.id, plan.stands ? " stands" : "");
    for (const LocatorJoint& joint : plan.joints) {
      text +=
          fmt::format("  {} below {} {}{} , {} {:.3f}\n", joint.name,
                      joint.parent.empty() ? "none" : joint.parent, joint.isNeeded ? "needed" : "not needed",
                      joint.facesUp ? " faces up" : "", limbName(joint.limb), joint.along);
    }
    for (const std::string& joint : plan.across) {
      text += "  across by " + joint + "\n";
    }
  }
  test::compareWithRecord("locator_plans", text, 1e-6);
}

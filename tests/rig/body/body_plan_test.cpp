#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "rig/plan/body_plan.h"

using namespace stretch;
using namespace stretch::rig;

TEST_CASE("Every body plan lists its limbs once, in the order of the keys, and mirrors its pairs") {
  REQUIRE(bodyPlans().front().id == "biped");
  REQUIRE(bodyPlans().back().id == "other");
  for (const BodyPlan& plan : bodyPlans()) {
    CAPTURE(plan.id);
    CHECK(planNamed(plan.id) == &plan);
    CHECK(std::ranges::is_sorted(plan.limbs, {}, &PlannedLimb::place));
    std::set<std::string> ids;
    int legs = 0;
    for (const PlannedLimb& limb : plan.limbs) {
      CAPTURE(limb.id);
      CHECK(ids.insert(limb.id).second);
      CHECK_FALSE(limb.bones.empty());
      CHECK(limb.place.kind != LimbKind::chain);
      REQUIRE(plannedLimb(plan, mirrored(limb.place)) != nullptr);
      CHECK((limb.place.side == LimbSide::middle) == (mirrored(limb.place) == limb.place));
      legs += isLeg(limb.place) ? 1 : 0;
    }
    CHECK(legs == plan.legs);
  }
}

TEST_CASE("A biped's limbs are named as ever, and lead the keys in the same order") {
  std::vector<std::string> ids;
  for (const PlannedLimb& limb : bodyPlans().front().limbs) {
    ids.push_back(limb.id);
    CHECK(limb.id == limbName(limb.place));
  }
  CHECK(ids ==
        std::vector<std::string>{"left-arm", "right-arm", "left-leg", "right-leg", "spine", "neck", "tail"});
}

TEST_CASE("A limb of a quadruped is found by its id, and a chain by none") {
  const BodyPlan* const plan = planNamed("quadruped");
  REQUIRE(plan != nullptr);
  CHECK(placeInPlan(*plan, "hind-left-leg") == LimbPlace{LimbKind::leg, LimbSide::left, 2});
  CHECK(placeInPlan(*plan, "left-arm") == LimbPlace{});
  CHECK(planNamed("centaur") == nullptr);
}

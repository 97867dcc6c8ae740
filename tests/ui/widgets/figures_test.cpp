#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "rig/plan/body_plan.h"

using namespace stretch;

TEST_CASE("The key of a limb stands clear of the rings about the ends of all limbs, in every figure") {
  constexpr float clear = 18.0F; // The ring's radius and half of a figure's width.
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    for (const rig::PlannedLimb& limb : plan.limbs) {
      for (const rig::PlannedLimb& other : plan.limbs) {
        INFO(plan.id << ": the key of " << limb.id << " beside the end of " << other.id);
        CHECK(std::hypot(limb.key.x - other.end.x, limb.key.y - other.end.y) > clear);
      }
    }
  }
}

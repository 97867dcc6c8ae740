#include <catch2/catch.hpp>

#include "app/edits/trail/style_edits.h"
#include "tests/support/refusal.h"

using namespace stretch;

namespace {

rig::Limb limbOf(const rig::LimbPlace& place, const char* id) {
  rig::Limb limb;
  static_cast<rig::LimbPlace&>(limb) = place;
  limb.id = id;
  return limb;
}

rig::Trail trailOf(int id, const char* limb) {
  rig::Trail trail;
  trail.id = id;
  trail.limb = limb;
  trail.settings.endFrame = 10.0;
  return trail;
}

/// Trails 1 to 3 on an arm, a leg and the spine.
app::Document threeTrails() {
  app::Document document;
  document.body.limbs = {limbOf(rig::biped::leftArm, "left-arm"), limbOf(rig::biped::leftLeg, "left-leg"),
                         limbOf(rig::biped::spine, "spine")};
  document.trails = {trailOf(1, "left-arm"), trailOf(2, "left-leg"), trailOf(3, "spine")};
  return document;
}

} // namespace

TEST_CASE("A style scales arms, legs and body as its cartoon does, and only the trails that are named") {
  const app::Document before = threeTrails();
  const app::Style& piggyBank = app::styles()[3];
  const Result<app::Document> after = app::applyStyle(before, {1, 2}, piggyBank);
  REQUIRE(after.ok());
  CHECK(after->trails[0].settings.scale == 2.0);
  CHECK(after->trails[1].settings.scale == 4.0);
  CHECK(after->trails[2].settings.scale == before.trails[2].settings.scale);
  CHECK(app::hasStyle(*after, {1, 2}, piggyBank));
  CHECK_FALSE(app::hasStyle(*after, {1, 2, 3}, piggyBank));
  CHECK_FALSE(app::hasStyle(*after, {1, 2}, app::styles()[0]));
}

TEST_CASE("A style for a trail that is not there is refused") {
  CHECK_THAT(test::refusal(app::applyStyle(threeTrails(), {7}, app::styles()[0])),
             Catch::StartsWith("trail 7: there is no such trail"));
}

TEST_CASE("No style stretches the body further than the limbs do") {
  for (const app::Style& style : app::styles()) {
    CAPTURE(style.name);
    CHECK(style.torso <= std::max(style.arm, style.leg));
    CHECK(app::scaleOf(style, rig::LimbKind::neck) == app::scaleOf(style, rig::LimbKind::spine));
  }
}

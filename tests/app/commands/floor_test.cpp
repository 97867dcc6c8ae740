#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/planted_feet.h"
#include "app/files/save.h"
#include "app/standing_floor.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double platformTop = 0.30; ///< Of the leap, where it ends.

Document leap() {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb");
  REQUIRE(opened);
  return std::move(opened).value();
}

} // namespace

TEST_CASE("A new trail of a leg stops at the floor that the feet stand on, one of an arm nowhere") {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const Session session(std::move(opened).value());
  const auto stopOf = [&](const char* limb) {
    return newTrailSettings(session, *findLimb(session.document(), limb), {0.0, 10.0}).stopAt;
  };
  REQUIRE(stopOf("left-leg"));
  CHECK(stopOf("left-leg")->normal == Vec3(0.0, -1.0, 0.0));
  CHECK(stopOf("left-leg")->point.y > 0.0); // The ankle, a little above the ground.
  CHECK(stopOf("left-leg")->point.y < 0.1 * session.document().body.height);
  CHECK(stopOf("right-leg")->point.y == Approx(stopOf("left-leg")->point.y).margin(0.03));
  CHECK_FALSE(stopOf("left-arm"));
}

TEST_CASE("A leg that comes down on a block stops at its top, one that leaves the floor at the floor") {
  const Session session(leap());
  const auto stopOf = [&](double first, double last) {
    const rig::Limb& leg = *findLimb(session.document(), "left-leg");
    return newTrailSettings(session, leg, {first, last}).stopAt.value().point.y;
  };
  CHECK(stopOf(10.0, 18.0) < platformTop);
  CHECK(stopOf(52.0, 62.0) > platformTop);
  CHECK(stopOf(52.0, 62.0) < platformTop + 0.2);
  CHECK(stopOf(52.0, 58.0) > platformTop); // Still in front of it, on the way down.
}

TEST_CASE("A foot that hangs down stops higher, so that its toes do not reach through the floor") {
  const Document document = leap();
  const rig::Limb& leg = *findLimb(document, "left-leg");
  const double standing = floorForLeg(document, 0, leg, 70.0)->point.y - platformTop;
  CHECK(floorForLeg(document, 0, leg, 38.0)->point.y > standing + 0.08);
}

TEST_CASE("A leg's stop at the ground goes along with its tip, and one that was set by hand stays") {
  Session session(leap());
  selectLimb(session, "left-leg", false);
  session.view().rangeStart = 38.0;
  session.view().rangeEnd = 62.0;
  const Result<ExaggerateTargets> targets = exaggerateTargets(session);
  REQUIRE(targets);
  rig::Trail trail = targets->document.trails[0];
  CHECK(trail.settings.stopAt->point.y > platformTop);
  trail.settings.pivot = rig::Pivot::end;
  const Result<Document> turned = setTrailSettings(targets->document, trail.id, trail.settings);
  REQUIRE(turned);
  CHECK(turned->trails[0].settings.stopAt->point.y < platformTop);
  trail.settings = turned->trails[0].settings;
  trail.settings.stopAt->point.y = 0.5;
  const Result<Document> byHand = setTrailSettings(*turned, trail.id, trail.settings);
  REQUIRE(byHand);
  trail.settings.pivot = rig::Pivot::start;
  const Result<Document> back = setTrailSettings(*byHand, trail.id, trail.settings);
  REQUIRE(back);
  CHECK(back->trails[0].settings.stopAt->point.y == 0.5);
}

TEST_CASE("Feet are found standing on a block as they are on the floor") {
  const rig::Holds found = plantedFeet(leap(), 0, {60.0, 78.0});
  REQUIRE(found.pins.size() == 2);
  for (const rig::Pin& pin : found.pins) {
    CHECK(pin.time.rangeFrames.x <= 65.0);
    CHECK(pin.time.rangeFrames.y >= 72.0);
  }
}

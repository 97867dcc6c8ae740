#include "app/evaluate/planted_feet.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/app/boxer.h"
#include "tests/support/app/standing_leg.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document standingBoxer() {
  Document document = test::boxer();
  test::addStandingLeg(document);
  return document;
}

} // namespace

TEST_CASE(
    "A foot that stands is pinned over the whole frames that are asked for, from the one in the middle") {
  const std::vector<rig::Pin> whole = plantedFeet(standingBoxer(), 0, {0.0, 20.0}).pins;
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].limb == "left-leg");
  CHECK(whole[0].clip == 0);
  CHECK(whole[0].time.rangeFrames == Vec2(0.0, 20.0));
  CHECK(whole[0].time.blendFrames == Vec2(2.0, 2.0));
  CHECK(whole[0].atFrame == 10.0);
  CHECK_FALSE(whole[0].turns); // the heel may come off
  const std::vector<rig::Pin> part = plantedFeet(standingBoxer(), 0, {3.5, 12.9}).pins;
  REQUIRE(part.size() == 1);
  CHECK(part[0].time.rangeFrames == Vec2(4.0, 12.0));
  CHECK(part[0].atFrame == 8.0);
  CHECK(plantedFeet(standingBoxer(), 0, {-7.0, 300.0}).pins[0].time.rangeFrames == Vec2(0.0, 20.0));
  CHECK(plantedFeet(standingBoxer(), 0, {4.0, 6.0}).pins.size() == 1);
  CHECK(plantedFeet(standingBoxer(), 0, {4.0, 5.9}).pins.empty()); // a frame is no stand
}

TEST_CASE(
    "A foot that is lifted for a moment is pinned before and after it, and both share what is between") {
  Document document = standingBoxer();
  Track lift;
  lift.node = findLimb(document, "left-leg")->joints.front();
  lift.channel = Channel::translation;
  lift.interpolation = Interpolation::step;
  lift.times = {0.0F, 9.0F / 30.0F, 9.7F / 30.0F};
  lift.values = {0.1F, 0.0F, 0.0F, 0.1F, 0.5F, 0.0F, 0.1F, 0.0F, 0.0F};
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.emplace_back(std::move(lift));
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  const std::vector<rig::Pin> pins = plantedFeet(document, 0, {0.0, 20.0}).pins;
  REQUIRE(pins.size() == 2);
  CHECK(pins[0].time.rangeFrames.x == 0.0);
  CHECK(pins[0].time.rangeFrames.y < 9.0);
  CHECK(pins[1].time.rangeFrames.x > 9.0);
  CHECK(pins[1].time.rangeFrames.y == 20.0);
  const double between = pins[1].time.rangeFrames.x - pins[0].time.rangeFrames.y;
  CHECK(pins[0].time.blendFrames == Vec2(2.0, std::min(2.0, 0.5 * between)));
  CHECK(pins[1].time.blendFrames == Vec2(std::min(2.0, 0.5 * between), 2.0));
}

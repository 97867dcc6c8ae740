// What becomes of frames, and of what names them, when a stretch of a clip takes another length.
#include "app/things/time_map.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

namespace {

/// Frames 2 to 8 take twice as long; what comes after moves along, or stays.
TimeMap slowedToHalf(bool movesAfter) {
  return {.first = 2.0, .last = 8.0, .factor = 2.0, .stays = 2.0, .movesAfter = movesAfter};
}

rig::OffsetKey slopingKey(double frame) {
  rig::OffsetKey key;
  key.frame = frame;
  key.value = 1.0;
  key.moveSlope = Vec3(1.0, 0.0, 0.0);
  key.turnSlope = Vec3(0.0, 2.0, 0.0);
  key.valueSlope = 4.0;
  return key;
}

std::vector<double> framesOfKeys(const std::vector<rig::OffsetKey>& keys) {
  std::vector<double> frames(keys.size());
  std::ranges::transform(keys, frames.begin(), &rig::OffsetKey::frame);
  return frames;
}

rig::Pin blendingPin(double first, double last) {
  rig::Pin pin;
  pin.limb = "left-arm";
  pin.time = {{first, last}, {3.0, 4.0}};
  pin.atFrame = first + 1.0;
  return pin;
}

} // namespace

TEST_CASE(
    "Frames of a slower stretch are farther apart, those before it stay, later ones move along or stay") {
  const TimeMap moves = slowedToHalf(true);
  const TimeMap stays = slowedToHalf(false);
  CHECK(moves.newLast() == 14.0);
  for (const TimeMap& map : {moves, stays}) {
    CHECK(map(-3.0) == -3.0);
    CHECK(map(2.0) == 2.0);
    CHECK(map(5.0) == 8.0);
    CHECK(map(8.0) == 14.0);
  }
  CHECK(moves(10.0) == 16.0);
  CHECK(stays(10.0) == 14.0); // is reached by the stretch
  CHECK(stays(14.0) == 14.0);
  CHECK(stays(15.5) == 15.5);
}

TEST_CASE("A whole clip that is counted at another rate has its frames on whole ones where they come near") {
  const TimeMap map{.factor = 2.0 + 1e-8};
  CHECK(map(-3.0) == -6.0);
  CHECK(map(0.0) == 0.0);
  CHECK(map(7.0) == 14.0);
  CHECK(map(0.3) == Approx(0.6));
  CHECK(map.lengthFrom(3.0, -2.0) == 4.0);
}

TEST_CASE("What is taken to come or to go is longer by as much of it as lies in the stretch") {
  for (const bool movesAfter : {true, false}) {
    const TimeMap map = slowedToHalf(movesAfter);
    CHECK(map.lengthFrom(4.0, 3.0) == 6.0);
    CHECK(map.lengthFrom(6.0, 4.0) == 6.0);   // two frames of it
    CHECK(map.lengthFrom(10.0, -4.0) == 6.0); // back from behind
    CHECK(map.lengthFrom(4.0, -3.0) == 5.0);
    CHECK(map.lengthFrom(0.0, 10.0) == 16.0);
    CHECK(map.lengthFrom(10.0, 3.0) == 3.0);
    CHECK(map.lengthFrom(1.0, -1.0) == 1.0);
  }
}

TEST_CASE("A key after the stretch gives way as far as the stretch reaches, where it does not move along") {
  const TimeMap stays = slowedToHalf(false);
  for (const double frame : {9.0, 14.0}) {
    CHECK(stays.givesWay(frame));
    CHECK_FALSE(slowedToHalf(true).givesWay(frame));
  }
  CHECK_FALSE(stays.givesWay(8.0)); // is the stretch's own
  CHECK_FALSE(stays.givesWay(14.5));
  CHECK(stays.leaves(14.5));
  CHECK(stays.leaves(8.5));
  CHECK_FALSE(stays.leaves(8.0));
  CHECK_FALSE(slowedToHalf(true).leaves(14.5));
}

TEST_CASE("A pin takes as much longer to come and to go as either lies in the stretch") {
  const rig::Pin pin = mapped(blendingPin(4.0, 6.0), slowedToHalf(true));
  CHECK(pin.time.rangeFrames == Vec2(6.0, 10.0));
  CHECK(pin.time.blendFrames == Vec2(5.0, 6.0)); // of 4 back to 1, of 6 on to 10
  CHECK(pin.atFrame == 8.0);
}

TEST_CASE("Keys of offsets change as much less for each frame as those are more, in the stretch alone") {
  rig::Adjustment hand;
  hand.controller = "left-hand";
  hand.keys = {slopingKey(1.0), slopingKey(4.0), slopingKey(10.0)};
  const rig::Adjustment moved = mapped(hand, slowedToHalf(true));
  CHECK(framesOfKeys(moved.keys) == std::vector<double>{1.0, 6.0, 16.0});
  for (const std::size_t outside : {0U, 2U}) {
    CHECK(moved.keys[outside].moveSlope == Vec3(1.0, 0.0, 0.0));
    CHECK(moved.keys[outside].valueSlope == 4.0);
  }
  CHECK(moved.keys[1].moveSlope == Vec3(0.5, 0.0, 0.0));
  CHECK(moved.keys[1].turnSlope == Vec3(0.0, 1.0, 0.0));
  CHECK(moved.keys[1].valueSlope == 2.0);
  CHECK(framesOfKeys(mapped(hand, slowedToHalf(false)).keys) == std::vector<double>{1.0, 6.0});
}

TEST_CASE("A hand that holds a prop keeps one of its keys, whatever gives way") {
  rig::Prop prop;
  prop.node = "Stick";
  prop.hands = {{"left-arm", {slopingKey(9.0), slopingKey(10.0)}},
                {"right-arm", {slopingKey(3.0), slopingKey(10.0)}}};
  const rig::Prop moved = mapped(prop, slowedToHalf(false));
  CHECK(framesOfKeys(moved.hands[0].keys) == std::vector<double>{10.0});
  CHECK(framesOfKeys(moved.hands[1].keys) == std::vector<double>{4.0});
}

TEST_CASE("A trail goes back by as many frames as its way back becomes, from the end that is not its pivot") {
  rig::Trail trail;
  trail.settings.startFrame = 4.0;
  trail.settings.endFrame = 6.0;
  trail.settings.releaseFrames = 4.0;
  trail.settings.lingerFrames = 3.0;
  trail.settings.spheres = {{5.0, Vec3(1.0), Vec3(2.0, 0.0, 0.0)}};
  const rig::TrailSettings forwards = mapped(trail, slowedToHalf(true)).settings;
  CHECK(forwards.startFrame == 6.0);
  CHECK(forwards.endFrame == 10.0);
  CHECK(forwards.releaseFrames == 6.0);
  CHECK(forwards.lingerFrames == 5.0);
  CHECK(forwards.spheres == std::vector<rig::SphereOffset>{{8.0, Vec3(1.0), Vec3(1.0, 0.0, 0.0)}});
  trail.settings.pivot = rig::Pivot::end;
  const rig::TrailSettings backwards = mapped(trail, slowedToHalf(true)).settings;
  CHECK(backwards.releaseFrames == 6.0); // two of its four frames are before the stretch
  CHECK(backwards.lingerFrames == 5.0);
}

TEST_CASE("What is left of a hold from a frame on is the rest of it, down to its last frame") {
  const std::optional<rig::Pin> rest = cutBefore(blendingPin(4.0, 6.0), 5.0);
  REQUIRE(rest);
  CHECK(rest->time.rangeFrames == Vec2(5.0, 6.0));
  CHECK(cutBefore(blendingPin(4.0, 6.0), 1.0)->time.rangeFrames == Vec2(4.0, 6.0));
  CHECK(cutBefore(blendingPin(4.0, 6.0), 6.0)->time.rangeFrames == Vec2(6.0, 6.0));
  CHECK_FALSE(cutBefore(blendingPin(4.0, 6.0), 6.5));
}

TEST_CASE("What is left of offsets from a frame on needs a key there, and of a trail some length") {
  rig::Adjustment hand;
  hand.controller = "left-hand";
  hand.rangeFrames = Vec2(4.0, 8.0);
  hand.keys = {slopingKey(4.0), slopingKey(6.0)};
  const std::optional<rig::Adjustment> rest = cutBefore(hand, 5.0);
  REQUIRE(rest);
  CHECK(rest->rangeFrames == Vec2(5.0, 8.0));
  CHECK(framesOfKeys(rest->keys) == std::vector<double>{6.0});
  CHECK(framesOfKeys(cutBefore(hand, 6.0)->keys) == std::vector<double>{6.0});
  CHECK_FALSE(cutBefore(hand, 7.0));
  rig::Trail trail;
  trail.settings.startFrame = 4.0;
  trail.settings.endFrame = 6.0;
  CHECK(cutBefore(trail, 5.5)->settings.startFrame == 5.5);
  CHECK_FALSE(cutBefore(trail, 6.0));
}

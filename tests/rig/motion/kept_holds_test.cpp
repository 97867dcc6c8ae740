// What is held where weight moves the limbs that hold it.
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/motion/apply_holds.h"
#include "rig/motion/solve_holds.h"
#include "tests/support/rig/held_biped.h"
#include "tests/support/rig/soft_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double unseenApart = 1e-7; // of a body about 1.8 units tall

SoftBones longerBones(double /*frame*/) {
  return {1.2, 0.9, 1.0, Vec3(0.3, 1.0, 0.2), 0.0};
}

// A leg that stands and gives way: the hips sink.
SoftBones squashedBones(double /*frame*/) {
  return {0.9, 1.05, 1.05, Vec3(0.0, 0.0, 1.0), 1.0, 1.0};
}

MotionState weightedMotion(const MovingBiped& moving, const Holds& holds,
                           const std::vector<LimbWeight>& weights) {
  MotionInput input = motionInput(moving, {});
  input.holds = holds;
  MotionState motion = held(input, holds);
  setWeight(input, weights, motion);
  return motion;
}

PropHand handOfProp(const std::string& limb, double firmness) {
  OffsetKey key;
  key.value = firmness;
  return {limb, {key}};
}

HeldPlace placeOfBat(const MovingBiped& moving, const FrameState& frame) {
  const Mat4& world = frame.worlds[at(moving.node.at("bat"))];
  return {positionOf(world), rotationOf(world)};
}

} // namespace

TEST_CASE("a pinned hand stays at its pin while its arm, or what carries it, gives way to its weight") {
  const MovingBiped moving = bipedWithBat();
  Holds holds;
  holds.pins = {pinAt("left-arm", heldOver(4, 18, 4, 4), 10)};
  const std::string limb = GENERATE("left-arm", "left-leg");
  const MotionState motion = weightedMotion(
      moving, holds,
      {limb == "left-arm" ? softLimb(moving, limb, longerBones) : softLimb(moving, limb, squashedBones)});
  const MotionState unweighted = held(moving, holds);
  MotionState free = motion;
  free.holds = {};
  const HeldPlace pinned = endPlaceOf(moving, "left-arm", sourceAtFrame(moving, 10));
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    CAPTURE(limb, frame);
    const HeldPlace after = endPlaceOf(moving, "left-arm", atFrame(moving, motion, frame));
    const HeldPlace without = endPlaceOf(moving, "left-arm", atFrame(moving, unweighted, frame));
    const double strength = motion.holds.pins[0]->span.strengthAt(frame / moving.clip.framesPerSecond);
    CHECK(turnApart(after, without) < 1e-6);
    if (strength >= 1.0) {
      CHECK(placesApart(after, pinned) < unseenApart);
    } else if (strength <= 0.0) {
      CHECK(placesApart(after, endPlaceOf(moving, "left-arm", atFrame(moving, free, frame))) < unseenApart);
      CHECK(placesApart(after, without) > 0.01); // the weight is to be seen
    } else {
      CHECK(placesApart(after, without) > 0.0);
    }
  }
}

TEST_CASE("a hand that grips another one goes along where that one's weight moves it") {
  const MovingBiped moving = bipedWithBat();
  Holds holds;
  Grip grip;
  grip.follower = "right-arm";
  grip.leader = "left-arm";
  grip.time = heldOver(0, 24);
  holds.grips = {grip};
  const MotionState motion = weightedMotion(moving, holds, {softLimb(moving, "left-arm", longerBones)});
  for (const double frame : {0.0, 7.5, 12.0}) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState after = atFrame(moving, motion, frame);
    const HeldPlace leader = endPlaceOf(moving, "left-arm", after);
    CHECK(placesApart(leader, endPlaceOf(moving, "left-arm", source)) > 0.01);
    CHECK(placesApart(seenFrom(leader, endPlaceOf(moving, "right-arm", after)),
                      seenFrom(endPlaceOf(moving, "left-arm", source),
                               endPlaceOf(moving, "right-arm", source))) < unseenApart);
  }
}

TEST_CASE("a prop stays in its hands, one or both, where the weight of one of them moves it") {
  const MovingBiped moving = bipedWithBat();
  const bool inBoth = GENERATE(true, false);
  Holds holds;
  Prop prop;
  prop.node = "bat";
  prop.boundFrame = 0.0;
  prop.hands = {handOfProp("left-arm", 1.0), handOfProp("right-arm", inBoth ? 1.0 : 0.0)};
  holds.props = {prop};
  const MotionState motion = weightedMotion(moving, holds, {softLimb(moving, "left-arm", longerBones)});
  const FrameState bound = sourceAtFrame(moving, 0);
  for (const double frame : {0.0, 7.5, 12.0}) {
    CAPTURE(inBoth, frame);
    const FrameState after = atFrame(moving, motion, frame);
    for (const char* hand : {"left-arm", "right-arm"}) {
      if (inBoth || hand == std::string("left-arm")) {
        CHECK(placesApart(seenFrom(endPlaceOf(moving, hand, after), placeOfBat(moving, after)),
                          seenFrom(endPlaceOf(moving, hand, bound), placeOfBat(moving, bound))) <
              unseenApart);
      }
    }
    CHECK(placesApart(placeOfBat(moving, after),
                      placeOfBat(moving, atFrame(moving, held(moving, holds), frame))) > 0.01);
  }
}

TEST_CASE("a prop in two hands goes along where weight moves one of them by that one's share of firmness") {
  const double left = GENERATE(1.0, 0.25);
  const double right = 0.5;
  CAPTURE(left);
  const MovingBiped moving = bipedWithBat();
  Prop prop;
  prop.node = "bat";
  prop.boundFrame.reset(); // it stays where the clip has it as long as no weight moves a hand
  prop.hands = {handOfProp("left-arm", left), handOfProp("right-arm", right)};
  Holds holds;
  holds.props = {prop};
  const MotionState motion = weightedMotion(moving, holds, {softLimb(moving, "left-arm", longerBones)});
  MotionState free = motion;
  free.holds = {};
  for (const double frame : {0.0, 7.5, 12.0}) {
    CAPTURE(frame);
    const FrameState source = sourceAtFrame(moving, frame);
    const Vec3 handMove = endPlaceOf(moving, "left-arm", atFrame(moving, free, frame)).position -
                          endPlaceOf(moving, "left-arm", source).position;
    REQUIRE(glm::length(handMove) > 0.01);
    const Vec3 batMove =
        placeOfBat(moving, atFrame(moving, motion, frame)).position - placeOfBat(moving, source).position;
    const double share = left / (left + right) * std::min(1.0, left + right);
    CHECK(glm::length(batMove - share * handMove) < unseenApart);
  }
}

TEST_CASE("weight that does not give way leaves every number of what is held alone") {
  const MovingBiped moving = bipedWithBat();
  Holds holds;
  holds.pins = {pinAt("left-arm", heldOver(4, 18, 4, 4), 10)};
  const MotionState motion = weightedMotion(
      moving, holds, {softLimb(moving, "left-arm", [](double /*frame*/) { return SoftBones{}; })});
  for (const double frame : {0.0, 2.5, 7.0, 20.0}) {
    CHECK(atFrame(moving, motion, frame).worlds == atFrame(moving, held(moving, holds), frame).worlds);
  }
}

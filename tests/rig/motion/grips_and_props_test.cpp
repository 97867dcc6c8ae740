#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/motion/apply_holds.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double unseen = 1e-7; // of a body about 1.8 units tall

Grip gripOf(const std::string& follower, const std::string& leader,
            std::optional<double> relationFrame = {}) {
  Grip grip;
  grip.follower = follower;
  grip.leader = leader;
  grip.time = heldOver(0, 24);
  grip.relationFrame = relationFrame;
  return grip;
}

// Away from where the clip has it, and turned there.
Pin pinnedAside(const MovingBiped& moving, const std::string& limb) {
  Pin pin = pinAt(limb, heldOver(0, 24), 0);
  HeldPlace place = endPlaceOf(moving, limb, sourceAtFrame(moving, 3));
  place.position += Vec3(-0.04, 0.03, 0.05);
  place.orientation = axisAngle(glm::normalize(Vec3(1, -1, 2)), 0.4) * place.orientation;
  pin.place = place;
  return pin;
}

// Of one place in the space of another, without asking the product.
HeldPlace relationOf(const HeldPlace& from, const HeldPlace& place) {
  const Quat back = glm::inverse(from.orientation);
  return {back * (place.position - from.position), back * place.orientation};
}

HeldPlace batOf(const MovingBiped& moving, const FrameState& frame) {
  const Mat4& world = frame.worlds[at(moving.node.at("bat"))];
  return {positionOf(world), rotationOf(world)};
}

PropHand firmHand(const std::string& limb, double firmness) {
  OffsetKey key;
  key.value = firmness;
  return {limb, {key}};
}

Prop propOf(const std::vector<PropHand>& hands, std::optional<double> boundFrame = 0.0) {
  Prop prop;
  prop.node = "bat";
  prop.boundFrame = boundFrame;
  prop.hands = hands;
  return prop;
}

Holds onlyProp(const Prop& prop) {
  Holds holds;
  holds.props = {prop};
  return holds;
}

HeldPlace batHeld(const MovingBiped& moving, const Prop& prop, double frame) {
  return batOf(moving, atFrame(moving, held(moving, onlyProp(prop)), frame));
}

} // namespace

TEST_CASE("a follower stays where it is seen from its leader, at one frame or at each") {
  const std::string leader = GENERATE(from_range(handsAndFeet));
  const std::string follower = GENERATE(from_range(handsAndFeet));
  if (leader == follower) {
    return;
  }
  const bool atOneFrame = GENERATE(true, false);
  CAPTURE(leader, follower, atOneFrame);
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.pins = {pinnedAside(moving, leader)};
  holds.grips = {gripOf(follower, leader, atOneFrame ? std::optional(6.0) : std::nullopt)};
  const MotionState motion = held(moving, holds);
  for (const double frame : {0.0, 4.5, 12.0, 24.0}) {
    const FrameState relationAt = sourceAtFrame(moving, atOneFrame ? 6.0 : frame);
    const HeldPlace wanted =
        relationOf(endPlaceOf(moving, leader, relationAt), endPlaceOf(moving, follower, relationAt));
    const FrameState after = atFrame(moving, motion, frame);
    const HeldPlace there =
        relationOf(endPlaceOf(moving, leader, after), endPlaceOf(moving, follower, after));
    CHECK(placesApart(there, wanted) < unseen);
    CHECK(turnApart(there, wanted) < 1e-6);
  }
}

TEST_CASE("a grip comes and goes beside its range") {
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.grips = {gripOf("right-arm", "left-arm", 0.0)};
  holds.grips.front().time = heldOver(12, 16, 4, 6);
  const MotionState motion = held(moving, holds);
  for (const double outside : {8.0, 22.0}) {
    CHECK(largestMatrixMiss(atFrame(moving, motion, outside), sourceAtFrame(moving, outside)) < 1e-12);
  }
  for (const double middle : {10.0, 19.0}) { // of the blends: half of the way
    const FrameState source = sourceAtFrame(moving, middle);
    const FrameState first = sourceAtFrame(moving, 0.0);
    const HeldPlace leader = endPlaceOf(moving, "left-arm", source);
    const HeldPlace seen =
        relationOf(endPlaceOf(moving, "left-arm", first), endPlaceOf(moving, "right-arm", first));
    const Vec3 whole = leader.position + leader.orientation * seen.position;
    const Vec3 own = endPlaceOf(moving, "right-arm", source).position;
    CHECK(glm::length(endPlaceOf(moving, "right-arm", atFrame(moving, motion, middle)).position -
                      0.5 * (own + whole)) < unseen);
  }
}

TEST_CASE("a grip follows a leader that another grip moves, in whatever order they are listed") {
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.pins = {pinnedAside(moving, "left-arm")};
  holds.grips = {gripOf("right-arm", "left-arm"), gripOf("right-leg", "right-arm"),
                 gripOf("left-leg", "right-leg")};
  const MotionState inOrder = held(moving, holds);
  std::ranges::sort(holds.grips, {}, &Grip::follower);
  do {
    const FrameState after = atFrame(moving, held(moving, holds), 9);
    CHECK(largestMatrixMiss(after, atFrame(moving, inOrder, 9)) < 1e-12);
    const FrameState source = sourceAtFrame(moving, 9);
    for (const Grip& grip : holds.grips) {
      CHECK(placesApart(
                relationOf(endPlaceOf(moving, grip.leader, after), endPlaceOf(moving, grip.follower, after)),
                relationOf(endPlaceOf(moving, grip.leader, source),
                           endPlaceOf(moving, grip.follower, source))) < unseen);
    }
  } while (std::next_permutation(holds.grips.begin(), holds.grips.end(),
                                 [](const Grip& a, const Grip& b) { return a.follower < b.follower; }));
}

TEST_CASE("of several holds of one limb the last acts, and those before are told as overridden") {
  const MovingBiped moving = bipedWithBat();
  Holds holds;
  holds.pins = {pinAt("right-arm", heldOver(0, 24), 3), pinnedAside(moving, "right-arm"),
                pinnedAside(moving, "left-leg")};
  const auto toldOf = [&] {
    const FrameState source = sourceAtFrame(moving, 12);
    FrameState frame = source;
    return applyHolds(moving.scene, held(moving, holds), source, frame);
  };
  std::vector<HeldGoal> told = toldOf();
  REQUIRE(told.size() == 3);
  CHECK(told[0].overriddenBy == HoldKind::pin);
  CHECK(told[1].kind == HoldKind::pin);
  CHECK(told[1].index == 1);
  CHECK(glm::length(told[1].wanted - holds.pins[1].place->position) < unseen);
  CHECK(told[2].index == 2);
  CHECK_FALSE(told[1].overriddenBy);
  CHECK_FALSE(told[2].overriddenBy);
  holds.grips = {gripOf("right-arm", "left-arm")};
  told = toldOf();
  REQUIRE(told.size() == 4);
  CHECK(told[1].overriddenBy == HoldKind::grip);
  CHECK(told[3].kind == HoldKind::grip);
  holds.props = {propOf({firmHand("right-arm", 0.5)})};
  told = toldOf();
  REQUIRE(told.size() == 5);
  CHECK(told[0].overriddenBy == HoldKind::prop);
  CHECK(told[3].overriddenBy == HoldKind::prop);
  CHECK(told[4].kind == HoldKind::prop);
  CHECK(told[4].strength == Approx(0.5));
  CHECK_FALSE(told[2].overriddenBy);
  CHECK_FALSE(told[4].overriddenBy);
}

TEST_CASE("a prop stays in the hand as it was bound, by its name or its number") {
  const std::string limb = GENERATE("left-arm", "right-arm");
  const double boundFrame = GENERATE(0.0, 6.0);
  const bool byNumber = GENERATE(true, false);
  const MovingBiped moving = bipedWithBat();
  Prop prop = propOf({firmHand(limb, 1.0)}, boundFrame);
  prop.node = byNumber ? "#" + std::to_string(at(moving.node.at("bat"))) : "bat";
  const MotionState motion = held(moving, onlyProp(prop));
  const FrameState bound = sourceAtFrame(moving, boundFrame);
  const HeldPlace wanted = relationOf(endPlaceOf(moving, limb, bound), batOf(moving, bound));
  for (const double frame : {0.0, 7.5, 12.0, 24.0}) {
    const FrameState after = atFrame(moving, motion, frame);
    const HeldPlace there = relationOf(endPlaceOf(moving, limb, after), batOf(moving, after));
    CHECK(placesApart(there, wanted) < unseen);
    CHECK(turnApart(there, wanted) < 1e-6);
    CHECK(placesApart(endPlaceOf(moving, limb, after),
                      endPlaceOf(moving, limb, sourceAtFrame(moving, frame))) < unseen);
  }
}

TEST_CASE("a prop that is bound at the source moves as the clip does while the hand stays where it is") {
  const MovingBiped moving = bipedWithBat();
  Holds holds = onlyProp(propOf({firmHand("right-arm", 1.0)}, std::nullopt));
  const MotionState still = held(moving, holds);
  holds.pins = {pinnedAside(moving, "right-arm")};
  const MotionState pinned = held(moving, holds);
  for (const double frame : {0.0, 9.0, 12.0}) {
    const FrameState source = sourceAtFrame(moving, frame);
    CHECK(placesApart(batOf(moving, atFrame(moving, still, frame)), batOf(moving, source)) < unseen);
    const FrameState after = atFrame(moving, pinned, frame);
    CHECK(placesApart(relationOf(endPlaceOf(moving, "right-arm", after), batOf(moving, after)),
                      relationOf(endPlaceOf(moving, "right-arm", source), batOf(moving, source))) < unseen);
  }
}

TEST_CASE("a prop is brought and turned before it is bound") {
  const std::optional<double> boundFrame = GENERATE(std::optional(0.0), std::optional<double>());
  const MovingBiped moving = bipedWithBat();
  Prop prop = propOf({firmHand("right-arm", 1.0)}, boundFrame);
  prop.move = Vec3(0.1, -0.2, 0.3);
  prop.turn = 0.9 * glm::normalize(Vec3(2, -1, 1));
  const HeldPlace own = batOf(moving, sourceAtFrame(moving, 0));
  const HeldPlace wanted{own.position + prop.move,
                         axisAngle(glm::normalize(prop.turn), 0.9) * own.orientation};
  const HeldPlace there = batHeld(moving, prop, 0);
  CHECK(placesApart(there, wanted) < unseen);
  CHECK(turnApart(there, wanted) < 1e-6);
}

TEST_CASE("a prop stands between the hands by their firmness, and each hand stays on it by its own") {
  const auto [left, right] = GENERATE(table<double, double>(
      {{1.0, 1.0}, {1.0, 0.5}, {0.25, 0.75}, {0.2, 0.4}, {0.0, 1.0}, {1.0, 0.0}, {0.3, 0.0}, {0.0, 0.0}}));
  CAPTURE(left, right);
  const MovingBiped moving = bipedWithBat();
  const FrameState source = sourceAtFrame(moving, 12);
  const FrameState bound = sourceAtFrame(moving, 0);
  const HeldPlace own = batOf(moving, source);
  const auto inHand = [&](const std::string& limb) {
    const HeldPlace hand = endPlaceOf(moving, limb, source);
    const HeldPlace seen = relationOf(endPlaceOf(moving, limb, bound), batOf(moving, bound));
    return HeldPlace{hand.position + hand.orientation * seen.position, hand.orientation * seen.orientation};
  };
  const double sum = left + right;
  HeldPlace heldAt = own;
  if (sum > 0.0) {
    const HeldPlace first = inHand("left-arm");
    const HeldPlace second = inHand("right-arm");
    heldAt = {glm::mix(first.position, second.position, right / sum),
              glm::slerp(first.orientation, second.orientation, right / sum)};
  }
  const Vec3 wanted = glm::mix(own.position, heldAt.position, std::min(1.0, sum));
  const Prop both = propOf({firmHand("left-arm", left), firmHand("right-arm", right)});
  const FrameState after = atFrame(moving, held(moving, onlyProp(both)), 12);
  CHECK(glm::length(batOf(moving, after).position - wanted) < unseen);
  const Prop other = propOf({firmHand("right-arm", right), firmHand("left-arm", left)});
  const FrameState reversed = atFrame(moving, held(moving, onlyProp(other)), 12);
  CHECK(largestMatrixMiss(reversed, after) < unseen);
  for (const auto& [limb, firmness] : {std::pair("left-arm", left), std::pair("right-arm", right)}) {
    const HeldPlace seen = relationOf(batOf(moving, bound), endPlaceOf(moving, limb, bound));
    const Vec3 onProp = heldAt.position + heldAt.orientation * seen.position;
    const Vec3 hand = endPlaceOf(moving, limb, source).position;
    CHECK(glm::length(endPlaceOf(moving, limb, after).position - glm::mix(hand, onProp, firmness)) < unseen);
  }
}

TEST_CASE("no hand holds a prop more than firmly, and none less than not at all") {
  const MovingBiped moving = bipedWithBat();
  const auto heldAs = [&](double left, double right) {
    const Prop prop = propOf({firmHand("left-arm", left), firmHand("right-arm", right)});
    return atFrame(moving, held(moving, onlyProp(prop)), 12);
  };
  CHECK(largestMatrixMiss(heldAs(1.7, 1.0), heldAs(1.0, 1.0)) < unseen);
  CHECK(largestMatrixMiss(heldAs(-0.5, 1.0), heldAs(0.0, 1.0)) < unseen);
}

TEST_CASE("a hand holds a prop until three frames before it lets it go") {
  const MovingBiped moving = bipedWithBat();
  PropHand hand = firmHand("right-arm", 1.0);
  hand.keys.push_back({});
  hand.keys.back().frame = 12.0;
  const Prop letGo = propOf({hand});
  const Prop always = propOf({firmHand("right-arm", 1.0)});
  const HeldPlace own = batOf(moving, sourceAtFrame(moving, 0));
  for (const double frame : {0.0, 6.0, 9.0}) {
    CHECK(placesApart(batHeld(moving, letGo, frame), batHeld(moving, always, frame)) < unseen);
  }
  const double whole = placesApart(own, batHeld(moving, always, 10.5));
  CHECK(placesApart(batHeld(moving, letGo, 10.5), own) == Approx(0.5 * whole).epsilon(1e-6));
  for (const double frame : {12.0, 18.0}) {
    CHECK(placesApart(batHeld(moving, letGo, frame), own) < unseen);
  }
}

TEST_CASE("a prop is held over its range, and comes and goes beside it") {
  const MovingBiped moving = bipedWithBat();
  Prop prop = propOf({firmHand("right-arm", 1.0)});
  const Prop always = prop;
  prop.time = heldOver(8, 14, 2, 6);
  const HeldPlace own = batOf(moving, sourceAtFrame(moving, 0));
  const auto [frame, share] = GENERATE(table<double, double>(
      {{5.0, 0.0}, {6.0, 0.0}, {7.0, 0.5}, {8.0, 1.0}, {14.0, 1.0}, {17.0, 0.5}, {20.0, 0.0}, {24.0, 0.0}}));
  CAPTURE(frame);
  const Vec3 wanted = glm::mix(own.position, batHeld(moving, always, frame).position, share);
  CHECK(glm::length(batHeld(moving, prop, frame).position - wanted) < unseen);
}

TEST_CASE("what holds cannot hold does nothing: no such node, no such hand, a part of the body") {
  const MovingBiped moving = bipedWithBat();
  Prop prop = propOf({firmHand("right-arm", 1.0)});
  prop.node = GENERATE("club", "", "#", "#-1", "#9999", "#3x", "part of the body");
  if (prop.node == "part of the body") {
    prop.node = "#" + std::to_string(at(moving.node.at("upperArm.r")));
  }
  Holds holds = onlyProp(prop);
  holds.props.push_back(propOf({firmHand("tail", 1.0)}));
  holds.grips = {gripOf("tail", "left-arm"), gripOf("left-arm", "tail"), gripOf("left-arm", "left-arm")};
  const MotionState motion = held(moving, holds);
  CHECK(largestMatrixMiss(atFrame(moving, motion, 12), sourceAtFrame(moving, 12)) < 1e-12);
}

TEST_CASE(
    "holds move with a character that stands elsewhere, turned, larger, with its nodes in another order") {
  BodyOptions options;
  options.neckJoints = 2; // A shuffle needs a number of joints that 7 does not divide.
  SyntheticBiped body = namedBody(options);
  const MovingBiped here = bipedWithBat(body);
  body.shuffled = GENERATE(false, true);
  MovingBiped there = bipedWithBat(body);
  Node& carrier = there.scene.nodes[0];
  carrier.rest = {Vec3(5, 2, -3), axisAngle(Vec3(0, 1, 0), 0.5 * pi), Vec3(3.0)};
  there.body = detectBody(there.scene);
  Holds holds;
  holds.pins = {pinAt("right-leg", heldOver(4, 20, 2, 3), 8)};
  holds.grips = {gripOf("right-arm", "left-arm", 6.0)};
  holds.grips.front().time = heldOver(0, 14, 0, 8);
  holds.props = {propOf({firmHand("left-arm", 0.7), firmHand("right-arm", 0.4)})};
  const MotionState first = held(here, holds);
  const MotionState second = held(there, holds);
  for (const double frame : {3.0, 8.0, 12.0, 17.0, 24.0}) {
    CAPTURE(frame);
    const FrameState a = atFrame(here, first, frame);
    const FrameState b = atFrame(there, second, frame);
    for (const auto& [key, node] : here.node) {
      CAPTURE(key);
      const Vec3 wanted =
          carrier.rest.translation + carrier.rest.rotation * (3.0 * positionOf(a.worlds[at(node)]));
      CHECK(glm::length(positionOf(b.worlds[at(there.node.at(key))]) - wanted) < 1e-6);
    }
  }
}

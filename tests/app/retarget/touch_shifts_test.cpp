#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/retarget/body_parts.h"
#include "app/retarget/body_touch.h"
#include "app/retarget/touch_shifts.h"
#include "core/math/rotation.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/rig/boxed_biped.h"

using namespace stretch;
using namespace stretch::app;
using test::MovingBiped;
using test::skeletonOf;

namespace {

constexpr double degree = pi / 180.0;
constexpr double seen = 0.01;       // of the height
constexpr double touchStarts = 0.8; // seconds
constexpr double touchEnds = 1.2;

FrameState stateAt(const MovingBiped& moving, const Clip& clip, double seconds) {
  return frameOf(moving.scene, samplePose(moving.scene, clip, seconds), seconds);
}

// The left arm goes from level to a pose, which it has from 0.8 s to 1.2 s, and back until 2 s. Angles in
// degrees: how far it is lifted, and how far the forearm bends further the same way.
Clip armClip(const MovingBiped& moving, double lifted, double bent) {
  Clip clip;
  clip.framesPerSecond = 24.0;
  for (const auto& [joint, angle] : {std::pair("upperArm.l", lifted), std::pair("foreArm.l", bent)}) {
    const Quat level(1.0, 0.0, 0.0, 0.0);
    const Quat turned = axisAngle(Vec3(0.0, 0.0, 1.0), angle * degree);
    clip.tracks.emplace_back(
        test::rotationTrack(moving.node.at(joint), Interpolation::linear,
                            {{0.0, level}, {touchStarts, turned}, {touchEnds, turned}, {2.0, level}}));
  }
  setEndsFromKeys(clip);
  return clip;
}

double handGap(const MovingBiped& moving, const Clip& clip, double seconds) {
  const rig::Skeleton skeleton = skeletonOf(moving);
  const HandDistances hands = BodyTouch(skeleton).handsAt(stateAt(moving, clip, seconds));
  REQUIRE(hands.toTrunk[rig::leftSide]);
  return *hands.toTrunk[rig::leftSide] / skeleton.height;
}

Inside insideAt(const MovingBiped& moving, const Clip& clip, double seconds) {
  return BodyTouch(skeletonOf(moving)).insideAt(stateAt(moving, clip, seconds));
}

Vec3 wristAt(const MovingBiped& moving, const Clip& clip, double seconds) {
  return rig::endPosition(moving.limb("left-arm"), stateAt(moving, clip, seconds).worlds);
}

// The forearm is bent until the hand touches.
Clip touchingClip(const MovingBiped& moving, double lifted, double direction) {
  for (double bent = 0.0; bent < 150.0; bent += 0.5) {
    Clip clip = armClip(moving, lifted, direction * bent);
    if (handGap(moving, clip, 1.0) < 0.004) {
      return clip;
    }
  }
  FAIL("the hand touches nothing");
  return {};
}

Clip onHip(const MovingBiped& moving) {
  return touchingClip(moving, -60.0, -1.0);
}

Clip onHead(const MovingBiped& moving) {
  return touchingClip(moving, 50.0, 1.0);
}

double gapOfHands(const MovingBiped& moving, const Clip& clip, double seconds) {
  const rig::Skeleton skeleton = skeletonOf(moving);
  const std::optional<double> gap = BodyTouch(skeleton).handsAt(stateAt(moving, clip, seconds)).toOther;
  REQUIRE(gap);
  return *gap / skeleton.height;
}

// Both arms go from level down before the trunk, and so far inwards that the hands touch. They hang: no work
// in common that would keep them as far from each other by itself.
Clip hangingTogether(const MovingBiped& moving) {
  const Quat level(1.0, 0.0, 0.0, 0.0);
  for (double inwards = 0.0; inwards < 0.5; inwards += 0.002) {
    Clip clip;
    clip.framesPerSecond = 24.0;
    for (const auto& [joint, side] : {std::pair("upperArm.l", 1.0), std::pair("upperArm.r", -1.0)}) {
      const Quat turned = shortestArc(Vec3(side, 0.0, 0.0), Vec3(-side * inwards, -0.9, 0.36));
      clip.tracks.emplace_back(
          test::rotationTrack(moving.node.at(joint), Interpolation::linear,
                              {{0.0, level}, {touchStarts, turned}, {touchEnds, turned}, {2.0, level}}));
    }
    setEndsFromKeys(clip);
    if (gapOfHands(moving, clip, 1.0) < 0.004) {
      return clip;
    }
  }
  FAIL("the hands do not touch");
  return {};
}

Clip brought(const MovingBiped& from, const Clip& clip, const MovingBiped& to, double amount) {
  const rig::Skeleton source = skeletonOf(from);
  const rig::Skeleton own = skeletonOf(to);
  const Result<rig::Retargeted> result = rig::retarget(source, clip, own, {}, rig::Correction::feetAndHands,
                                                       touchShifts({source, clip}, own, amount));
  REQUIRE(result);
  return result->clip;
}

double largestBend(const MovingBiped& moving, const Clip& clip) {
  double largest = 0.0;
  for (int frame = 1; frame < 48; ++frame) {
    const auto wrist = [&](int at) { return wristAt(moving, clip, at / 24.0); };
    largest = std::max(largest, glm::length(wrist(frame - 1) - 2.0 * wrist(frame) + wrist(frame + 1)));
  }
  return largest;
}

} // namespace

TEST_CASE("A hand that touches its hip in the source touches the hip of a fatter and of a thinner body") {
  const MovingBiped source = test::boxedBiped();
  const Clip clip = onHip(source);
  for (const double width : {0.24, 0.09}) {
    CAPTURE(width);
    const MovingBiped own = test::boxedBiped({.trunk = {width, 0.3, 0.8 * width}});
    const Clip mapped = brought(source, clip, own, 0.0);
    const Clip result = brought(source, clip, own, 1.0);
    REQUIRE((handGap(own, mapped, 1.0) > 2.0 * seen || insideAt(own, mapped, 1.0).deepest > 0.04));
    for (const double seconds : {0.85, 1.0, 1.15}) {
      CHECK(handGap(own, result, seconds) < seen);
      CHECK(insideAt(own, result, seconds).deepest < seen * 1.8);
    }
    const Vec3 there = wristAt(own, result, 1.0);
    CHECK(there.x > width);
    CHECK(there.y == Approx(wristAt(source, clip, 1.0).y).margin(0.05));
  }
}

TEST_CASE("A hand that touches its head in the source touches a larger and a smaller head") {
  const MovingBiped source = test::boxedBiped();
  const Clip clip = onHead(source);
  for (const double size : {0.17, 0.07}) {
    CAPTURE(size);
    const MovingBiped own = test::boxedBiped({.head = Vec3(size)});
    const Clip mapped = brought(source, clip, own, 0.0);
    const Clip result = brought(source, clip, own, 1.0);
    REQUIRE((handGap(own, mapped, 1.0) > 2.0 * seen || insideAt(own, mapped, 1.0).deepest > 0.04));
    CHECK(handGap(own, result, 1.0) < seen);
    CHECK(insideAt(own, result, 1.0).deepest < seen * 1.8);
  }
}

TEST_CASE("Hands that touch each other touch on a body of shorter arms, and either goes half the way") {
  const MovingBiped source = test::boxedBiped({.trunk = {0.1, 0.3, 0.02}});
  const MovingBiped own = test::boxedBiped({.trunk = {0.1, 0.3, 0.02}, .armLength = 0.7});
  const Clip clip = hangingTogether(source);
  const Clip mapped = brought(source, clip, own, 0.0);
  const Clip result = brought(source, clip, own, 1.0);
  REQUIRE(gapOfHands(own, mapped, 1.0) > 2.0 * seen);
  for (const double seconds : {0.85, 1.0, 1.15}) {
    CHECK(gapOfHands(own, result, seconds) < seen);
  }
  const Vec3 leftWay = wristAt(own, result, 1.0) - wristAt(own, mapped, 1.0);
  const auto right = [&](const Clip& shown) {
    return rig::endPosition(own.limb("right-arm"), stateAt(own, shown, 1.0).worlds);
  };
  const Vec3 rightWay = right(result) - right(mapped);
  CHECK(leftWay.x < 0.0);
  CHECK(rightWay.x == Approx(-leftWay.x).epsilon(0.2));
}

TEST_CASE(
    "Hands are brought to what they touch by an amount: none leaves every key, half goes half the way") {
  const MovingBiped source = test::boxedBiped();
  const Clip clip = onHip(source);
  const MovingBiped own = test::boxedBiped({.trunk = {0.09, 0.3, 0.08}});
  const rig::Skeleton from = skeletonOf(source);
  const rig::Skeleton onto = skeletonOf(own);
  const Result<rig::Retargeted> plain = rig::retarget(from, clip, onto);
  REQUIRE(plain);
  const Clip none = brought(source, clip, own, 0.0);
  CHECK(none == plain->clip);
  const Vec3 before = wristAt(own, none, 1.0);
  const Vec3 way = wristAt(own, brought(source, clip, own, 1.0), 1.0) - before;
  REQUIRE(glm::length(way) > 0.03);
  const Vec3 half = wristAt(own, brought(source, clip, own, 0.5), 1.0) - before;
  CHECK(glm::length(half - 0.5 * way) < 0.05 * glm::length(way));
}

TEST_CASE("Arms do not enter a trunk that is fatter than the source's, whether that is shown or not") {
  const MovingBiped source = test::boxedBiped();
  const MovingBiped unseen = test::bareBiped(test::namedBody({.toes = false, .fingers = false}));
  const MovingBiped own = test::boxedBiped({.trunk = {0.3, 0.3, 0.25}});
  for (const MovingBiped* from : {&source, &unseen}) {
    CAPTURE(from == &source);
    const Clip clip = armClip(*from, -75.0, -15.0); // hangs beside the trunk
    REQUIRE(insideAt(source, clip, 1.0).share == 0.0);
    const Inside mapped = insideAt(own, brought(*from, clip, own, 0.0), 1.0);
    const Inside result = insideAt(own, brought(*from, clip, own, 1.0), 1.0);
    REQUIRE(mapped.deepest > 0.05);
    CHECK(result.deepest < 0.3 * mapped.deepest);
    CHECK(result.share <= mapped.share);
  }
}

TEST_CASE("What is within the trunk in the bind pose, as hands in a robe, is left where it is") {
  const MovingBiped unseen = test::bareBiped(test::namedBody({.toes = false, .fingers = false}));
  const MovingBiped own = test::boxedBiped({.trunk = {0.9, 0.6, 0.4}});
  const Clip clip = armClip(unseen, -30.0, -15.0);
  REQUIRE(insideAt(own, brought(unseen, clip, own, 0.0), 1.0).share > 0.3);
  CHECK(brought(unseen, clip, own, 1.0) == brought(unseen, clip, own, 0.0));
}

TEST_CASE("What an arm does not reach at all is left as the joints have it") {
  const MovingBiped source = test::boxedBiped();
  const MovingBiped own = test::boxedBiped({.trunk = {0.04, 0.3, 0.04}, .armLength = 0.25});
  const Clip clip = onHip(source);
  const Clip mapped = brought(source, clip, own, 0.0);
  const Clip result = brought(source, clip, own, 1.0);
  REQUIRE(handGap(own, mapped, 1.0) > 2.0 * seen);
  CHECK(glm::length(wristAt(own, result, 1.0) - wristAt(own, mapped, 1.0)) < 1e-3);
}

TEST_CASE("A hand comes to what it touches and goes again without a jump, and no foot moves for it") {
  const MovingBiped source = test::boxedBiped();
  const MovingBiped own = test::boxedBiped({.trunk = {0.24, 0.3, 0.2}});
  const Clip clip = onHip(source);
  const Clip mapped = brought(source, clip, own, 0.0);
  const Clip result = brought(source, clip, own, 1.0);
  constexpr double little = 0.006; // of the height, in a frame
  REQUIRE(glm::length(wristAt(own, result, 1.0) - wristAt(own, mapped, 1.0)) > 0.05);
  CHECK(largestBend(own, result) < 1.5 * largestBend(own, mapped) + little * skeletonOf(own).height);
  for (const char* leg : {"left-leg", "right-leg"}) {
    for (int frame = 0; frame <= 48; frame += 4) {
      const double seconds = frame / 24.0;
      CHECK(rig::endPosition(own.limb(leg), stateAt(own, mapped, seconds).worlds) ==
            rig::endPosition(own.limb(leg), stateAt(own, result, seconds).worlds));
    }
  }
  CHECK(glm::length(wristAt(own, result, 0.0) - wristAt(own, mapped, 0.0)) < seen * skeletonOf(own).height);
}

TEST_CASE("Bringing hands to what they touch tells how far it is, and is stopped on the way") {
  const MovingBiped source = test::boxedBiped();
  const MovingBiped own = test::boxedBiped({.trunk = {0.24, 0.3, 0.2}});
  const Clip clip = onHip(source);
  const rig::Skeleton from = skeletonOf(source);
  const rig::Skeleton onto = skeletonOf(own);
  std::vector<double> shares;
  const auto retargeted = [&](double until) {
    const auto proceed = [&](double share) {
      shares.push_back(share);
      return share < until;
    };
    return rig::retarget(from, clip, onto, proceed, rig::Correction::feetAndHands,
                         touchShifts({from, clip}, onto, 1.0));
  };
  REQUIRE(retargeted(2.0));
  CHECK(std::ranges::is_sorted(shares));
  CHECK(std::ranges::count_if(shares, [](double share) { return share > 0.35 && share < 0.55; }) > 20);
  shares.clear();
  CHECK_FALSE(retargeted(0.45));
  CHECK(shares.size() > 20);
  CHECK(shares.back() < 0.7);
}

TEST_CASE("A triangle of the trunk is of the head where all of its vertices follow that") {
  const Document document = test::openedFile(test::posedCharacter);
  const std::optional<rig::Skeleton> skeleton = rig::skeletonOf(*document.scene, document.body);
  REQUIRE(skeleton);
  const Scene& scene = *skeleton->scene;
  const std::vector<NodeIndex> strongest = skinning::strongestNodes(scene);
  const auto isOfHead = [&](std::uint32_t vertex) {
    NodeIndex node = strongest[vertex];
    while (node.exists() && node != skeleton->head) {
      node = scene.nodes[at(node)].parent;
    }
    return node.exists();
  };
  const BodyParts parts = bodyPartsOf(*skeleton);
  REQUIRE(parts.isOfHead.size() == parts.trunk.size());
  std::size_t mixed = 0;
  for (std::size_t i = 0; i < parts.trunk.size(); ++i) {
    CHECK(parts.isOfHead[i] == std::ranges::all_of(parts.trunk[i], isOfHead));
    mixed += !parts.isOfHead[i] && std::ranges::any_of(parts.trunk[i], isOfHead) ? 1 : 0;
  }
  CHECK(mixed > 0);
  CHECK(std::ranges::count(parts.isOfHead, true) > 0);
}

TEST_CASE("What a hand holds is no hand, where that has a surface of its own") {
  MovingBiped moving = test::still(test::namedBody());
  const std::size_t before = bodyPartsOf(skeletonOf(moving)).arms[rig::leftSide].hand.size();
  REQUIRE(before > 0);
  test::addBox(moving, "hand.l", {0.75, 1.43, 0.4}, {0.02, 0.02, 0.4});
  const ArmParts skinned = bodyPartsOf(skeletonOf(moving)).arms[rig::leftSide];
  CHECK(skinned.hand.size() == before);
  CHECK(skinned.held.size() == 8);
  const ArmParts boxes = bodyPartsOf(skeletonOf(test::boxedBiped())).arms[rig::leftSide];
  CHECK(boxes.hand.size() == 8);
  CHECK(boxes.held.empty());
}

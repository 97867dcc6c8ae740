#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/prop_flips.h"
#include "core/math/rotation.h"
#include "rig/motion/solved_holds.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/things_of_clip.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double degreeOfHand = pi / 180.0;

/// The boxer whose left hand turns evenly by so much to frame 20, pinned over its first two frames and let go
/// over the 18 after them.
Document lettingGo(double degrees, bool turns = true) {
  Document document = test::twoPunches();
  Track track = test::turnsOf(document, "left-arm");
  track.node = findLimb(document, "left-arm")->endNode;
  for (int i = 0; i <= 8; ++i) {
    test::addKey(track, 2.5 * i, glm::angleAxis(degrees * degreeOfHand * i / 8.0, Vec3(1, 0, 0)));
  }
  document = test::withTracks(document, {track});
  rig::Pin pin;
  pin.limb = "left-arm";
  pin.time = {{0.0, 2.0}, {0.0, 18.0}};
  pin.turns = turns;
  document.holds.pins = {pin};
  return document;
}

std::vector<EndFlip> endFlipsOf(const Document& document) {
  return endFlips(document, prepareMotion(document, 0));
}

} // namespace

TEST_CASE("A hand that is let go while it passes half a turn from its pin turns over there, and it is told") {
  // It is turned by 180 degrees at frame 12, where the pin has 42 % of it.
  const std::vector<EndFlip> flips = endFlipsOf(lettingGo(298.0));
  REQUIRE(flips.size() == 1);
  CHECK(flips[0].limb == "left-arm");
  CHECK(flips[0].kind == rig::HoldKind::pin);
  CHECK(flips[0].frame == 12.5);
  CHECK(flips[0].degrees > 100.0);
  CHECK(
      endFlipWarning({rig::HoldKind::grip, "left-arm", 12.5, 150.4}) ==
      "the end of left-arm turns over by 150 degrees at frame 12.5, as its grip comes or goes: it is turned "
      "by half a turn there against how that has it; let the blend be shorter, or the hold leave its turn "
      "free");
}

TEST_CASE("A hand that stays within half a turn of its pin, or whose pin leaves its turn free, turns over "
          "nowhere") {
  CHECK(endFlipsOf(lettingGo(170.0)).empty());
  CHECK(endFlipsOf(lettingGo(298.0, false)).empty());
}

TEST_CASE("A hand whose grip goes turns over nowhere while it only follows a leader that turns fast") {
  Document document = test::twoPunches();
  Track leader = test::turnsOf(document, "left-arm");
  leader.node = findLimb(document, "left-arm")->endNode;
  for (const auto& [frame, degrees] : {std::pair(0.0, 0.0), {8.0, 0.0}, {8.5, 100.0}, {20.0, 100.0}}) {
    test::addKey(leader, frame, glm::angleAxis(degrees * degreeOfHand, Vec3(1, 0, 0)));
  }
  document = test::withTracks(document, {leader});
  rig::Grip grip;
  grip.follower = "right-arm";
  grip.leader = "left-arm";
  grip.time = {{0.0, 2.0}, {0.0, 18.0}}; // two thirds of it are left at frame 8
  grip.relationFrame = 0.0;
  document.holds.grips = {grip};
  const rig::MotionState motion = prepareMotion(document, 0);
  const auto turnOfFollower = [&](double frame) {
    const FrameState state = evaluate(document, motion, frame / 30.0);
    return rig::endPlace(*findLimb(document, "right-arm"), state).orientation;
  };
  CHECK(angleBetween(turnOfFollower(8.0), turnOfFollower(8.5)) > 50.0 * degreeOfHand); // as a flip would
  CHECK(endFlips(document, motion).empty());
}

#include <catch2/catch.hpp>

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/pose/library_posing.h"
#include "app/commands/pose/posing.h"
#include "app/commands/pose/seen_posing.h"
#include "app/commands/table/selection.h"
#include "app/named.h"
#include "core/math/rotation.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double frameOfPunch = 27.0;

SeenPose seenAt(Session& session, double frame) {
  session.view().frame = frame;
  return standardised(seenAtPlayhead(session, chosenControllers(session)));
}

const SeenController& seenOf(const SeenPose& pose, const std::string& id) {
  const auto found = std::ranges::find(pose.controllers, id, &SeenController::id);
  REQUIRE(found != pose.controllers.end());
  return *found;
}

rig::PlacedController placedNow(Session& session, const std::string& id) {
  const std::vector<rig::PlacedController>& placed = session.controllersAt(session.view().frame);
  const auto found = std::ranges::find(placed, id, &rig::PlacedController::id);
  REQUIRE(found != placed.end());
  return *found;
}

/// Where the hips stand on the ground.
Vec3 standing(Session& session) {
  const Vec3 hips = placedNow(session, "hips").placeWorld;
  return {hips.x, 0.0, hips.z};
}

std::vector<std::string> idsOf(const OffsetPose& pose) {
  std::vector<std::string> ids;
  std::ranges::transform(pose.offsets, std::back_inserter(ids), &ControllerOffset::id);
  return ids;
}

} // namespace

TEST_CASE("A pose in standard form stands at the origin, faces +Z and counts in lengths of the leg") {
  SeenPose pose;
  pose.standingWorld = Vec3(3.0, 0.0, 4.0);
  pose.leftWorld = Vec3(0.0, 0.0, -1.0); // It faces +X.
  pose.leftOnItsWay = Vec3(0.0, 0.0, -1.0);
  pose.legLength = 2.0;
  const Quat quarter = axisAngle(Vec3(1.0, 0.0, 0.0), 0.5 * pi); // About the way that it faces.
  pose.controllers = {{"right-hand", Vec3(5.0, 3.0, 4.0), quarter, Vec3(0.5, 0.25, 0.0)}};
  pose.values = {{"right-hand.curl", 0.5}};
  const SeenPose standard = standardised(pose);
  CHECK(standard.of == nullptr);
  CHECK(standard.standingWorld == Vec3(0.0));
  CHECK(standard.legLength == 1.0);
  CHECK(standard.leftWorld == Vec3(1.0, 0.0, 0.0));
  CHECK(glm::length(standard.leftOnItsWay - Vec3(1.0, 0.0, 0.0)) < 1e-12);
  const SeenController& hand = standard.controllers.front();
  CHECK(glm::length(hand.placeWorld - Vec3(0.0, 1.5, 1.0)) < 1e-12);
  CHECK(glm::length(*hand.fromBase - Vec3(0.0, 0.25, 0.5)) < 1e-12);
  CHECK(angleBetween(hand.turnWorld, axisAngle(Vec3(0.0, 0.0, 1.0), 0.5 * pi)) < 1e-7);
  CHECK(standard.values == pose.values);
}

TEST_CASE(
    "A pose of the library is taken by halves: offsets half as far, and wholly every controller is there") {
  Session session(test::openedFile(test::posedCharacter));
  const SeenPose punch = seenAt(session, frameOfPunch);
  session.view().frame = 5.0;
  const rig::PlacedController before = placedNow(session, "left-hand");
  const Result<PoseBlend> blend = blendInto(session, punch);
  REQUIRE(blend);
  CHECK(blend->missed.empty());
  REQUIRE(blend->from.offsets.size() == blend->to.offsets.size());
  const OffsetPose half = blended(*blend, 0.5);
  REQUIRE(half.offsets.size() == blend->to.offsets.size());
  for (std::size_t i = 0; i < half.offsets.size(); ++i) {
    CHECK(half.offsets[i].id == blend->from.offsets[i].id);
    CHECK(glm::length(half.offsets[i].move - 0.5 * blend->to.offsets[i].move) < 1e-12);
    CHECK(glm::length(half.offsets[i].turn - 0.5 * blend->to.offsets[i].turn) < 1e-12);
  }
  CHECK(blended(*blend, 0.0) == blend->from);
  REQUIRE(poseAll(session, blended(*blend, 1.0), "Take"));
  const Vec3 wanted = seenOf(punch, "left-hand").placeWorld;
  const double leg = controllersOf(session.document()).controller("hips")->length;
  const Vec3 now = (placedNow(session, "left-hand").placeWorld - standing(session)) / leg;
  CHECK(glm::length(now - wanted) < 5e-3);
  CHECK(glm::length(placedNow(session, "left-hand").placeWorld - before.placeWorld) > 0.1);
}

TEST_CASE(
    "A value is blended from what it is to what the pose has, and what was posed before is where it begins") {
  Session session(test::openedFile(test::posedCharacter));
  session.view().frame = 5.0;
  REQUIRE(poseAll(session, {{}, {{"left-hand.curl", 1.0}}}, "Fist"));
  const SeenPose fist = seenAt(session, 5.0);
  REQUIRE(poseAll(session, {{}, {{"left-hand.curl", -0.2}}}, "Open"));
  const Result<PoseBlend> blend = blendInto(session, fist);
  REQUIRE(blend);
  CHECK(blend->from.values == std::vector<AttributeValue>{{"left-hand.curl", -0.2}});
  CHECK(blend->to.values == std::vector<AttributeValue>{{"left-hand.curl", 1.0}});
  CHECK(blended(*blend, 0.25).values.front().value == Approx(0.1));
}

TEST_CASE("Hips and feet are as far from where they rest, whatever the proportions of who was seen") {
  Session session(test::openedFile(test::posedCharacter));
  SeenPose punch = seenAt(session, frameOfPunch);
  session.view().frame = 5.0;
  const auto goalHeights = [&](const SeenPose& pose) {
    std::vector<double> heights;
    for (const SeenController& goal :
         goalsOn({session.document(), 0, 5.0, session.controllersAt(5.0), session.frameAt(5.0)}, pose,
                 Vec3(0.0))) {
      heights.push_back(goal.placeWorld.y);
    }
    return heights;
  };
  const std::vector<double> plain = goalHeights(punch);
  for (const char* const id : {"hips", "left-foot", "right-foot"}) {
    CHECK(seenOf(punch, id).restHeight.has_value());
  }
  for (SeenController& seen : punch.controllers) { // As if all were half a leg higher on whom it was seen.
    if (seen.restHeight) {
      seen.placeWorld.y += 0.5;
      *seen.restHeight += 0.5;
    }
  }
  const std::vector<double> higher = goalHeights(punch);
  REQUIRE(higher.size() == plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(higher[i] == Approx(plain[i]).margin(1e-9));
  }
  // Where nothing tells how high it rests, it goes by the length of the leg alone.
  const double leg = controllersOf(session.document()).controller("hips")->length;
  SeenPose bare = punch;
  bare.controllers = {{"hips", Vec3(0.0, 1.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), std::nullopt}};
  CHECK(goalHeights(bare).front() == Approx(leg));
}

TEST_CASE("Selected controllers alone take the pose, with the attributes that go with them") {
  Session session(test::openedFile(test::posedCharacter));
  const SeenPose punch = seenAt(session, frameOfPunch);
  session.view().frame = 5.0;
  selectControllers(session, {"left-hand", "head"});
  const Result<PoseBlend> blend = blendInto(session, punch);
  REQUIRE(blend);
  for (const std::string& id : idsOf(blend->to)) {
    INFO(id);
    CHECK((id == "left-hand" || id == "head"));
  }
  CHECK(std::ranges::count(idsOf(blend->to), "left-hand") == 1);
}

TEST_CASE("A pose is put on the controllers of the selected limb alone, and copied from them") {
  Session session(test::openedFile(test::posedCharacter));
  const SeenPose punch = seenAt(session, frameOfPunch);
  session.view().frame = 5.0;
  selectLimb(session, "left-arm", false);
  CHECK(chosenText(session) == "the left hand and left elbow");
  const Result<PoseBlend> blend = blendInto(session, punch);
  REQUIRE(blend);
  REQUIRE(std::ranges::count(idsOf(blend->to), "left-hand") == 1);
  for (const std::string& id : idsOf(blend->to)) {
    INFO(id);
    CHECK(id.starts_with("left-"));
    CHECK(id.find("leg") == std::string::npos);
    CHECK(id.find("foot") == std::string::npos);
  }
  const SeenPose copied = seenAtPlayhead(session, chosenControllers(session));
  CHECK(copied.controllers.size() == 2);
  CHECK(std::ranges::find(copied.controllers, "left-elbow", &SeenController::id) != copied.controllers.end());
  selectController(session, "head", false);
  REQUIRE(seenAtPlayhead(session, chosenControllers(session)).controllers.size() == 1);
  CHECK(seenAtPlayhead(session, chosenControllers(session)).controllers.front().id == "head");
}

TEST_CASE("A pose that cannot be taken says why") {
  Session session(test::openedFile(test::posedCharacter));
  const SeenPose punch = seenAt(session, frameOfPunch);
  SECTION("the character stands so") {
    CHECK_THAT(test::refusal(blendInto(session, punch)),
               Catch::StartsWith("the character stands so already"));
  }
  SECTION("it has none of the selected controllers") {
    SeenPose feet = punch;
    std::erase_if(feet.controllers, [](const SeenController& seen) { return seen.id != "left-foot"; });
    selectControllers(session, {"left-hand"});
    CHECK_THAT(test::refusal(blendInto(session, feet)),
               Catch::StartsWith("the pose has none of the selected controllers"));
  }
  SECTION("the character has none of its controllers") {
    SeenPose wings = punch;
    for (SeenController& seen : wings.controllers) {
      seen.id += "-wing";
    }
    CHECK_THAT(test::refusal(blendInto(session, wings)),
               Catch::StartsWith("this character has none of the pose's controllers"));
  }
}

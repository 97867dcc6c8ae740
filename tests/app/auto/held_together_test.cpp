#include "app/auto/held_together.h"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double armReach = 0.6; // Length of the boxer's arms; their shoulders are 0.4 apart.

/// How two hands go together: both arms turn inwards, and the chest takes them round.
struct TwoHands {
  double inwards = 1.95;                         ///< Radians, from straight out to the sides.
  double round = 1.0;                            ///< Radians that the chest turns by from frame 0 to 20.
  std::vector<double> wanders = {0, 0, 0, 0, 0}; ///< Radians of the right arm alone at frames 0, 5, 10,
                                                 ///< 15, 20.
};

Document swinging(const TwoHands& hands) {
  const Document start = test::boxer();
  Track chest = test::turnsOf(start, "spine");
  Track left = test::turnsOf(start, "left-arm");
  Track right = test::turnsOf(start, "right-arm");
  for (std::size_t i = 0; i < 5; ++i) {
    const double frame = 5.0 * static_cast<double>(i);
    test::addKey(chest, frame, glm::angleAxis(hands.round * frame / 20.0, Vec3(0, 1, 0)));
    test::addKey(left, frame, glm::angleAxis(hands.inwards, Vec3(0, -1, 0)));
    test::addKey(right, frame, glm::angleAxis(hands.inwards + hands.wanders[i], Vec3(0, 1, 0)));
  }
  return test::withTracks(start, {chest, left, right});
}

ClipGround joinedGround(const Document& document, double lastFrame = 20.0) {
  ClipGround ground{document, 0};
  ground.framesPerSecond = 30.0;
  ground.lastFrame = lastFrame;
  ground.turnFrames = lastFrame;
  return ground;
}

PlannedTrail plannedTrail(std::size_t moment, const std::string& limb, double startFrame, double endFrame,
                          double release = 0.0) {
  PlannedTrail trail;
  trail.moment = moment;
  trail.trail.limb = limb;
  trail.trail.settings.startFrame = startFrame;
  trail.trail.settings.endFrame = endFrame;
  trail.trail.settings.releaseFrames = release;
  return trail;
}

AutoPlan planOf(const std::vector<PlannedTrail>& trails) {
  AutoPlan plan;
  plan.trails = trails;
  plan.leftOut.resize(trails.size());
  return plan;
}

std::size_t gripsOver(const Document& document, double startFrame, double endFrame,
                      const std::string& limb = "left-arm") {
  AutoPlan plan = planOf({plannedTrail(0, limb, startFrame, endFrame)});
  const std::size_t count = gripsFor(joinedGround(document), plan).size();
  CHECK(plan.trails.size() == 1);
  return count;
}

} // namespace

TEST_CASE("A hand that keeps its place in the other one follows it while the trail does anything") {
  const Document document = swinging({});
  const auto [limb, other] =
      GENERATE(table<std::string, std::string>({{"left-arm", "right-arm"}, {"right-arm", "left-arm"}}));
  AutoPlan plan = planOf({plannedTrail(0, limb, 2.0, 12.0, 4.0)});
  const std::vector<rig::Grip> grips = gripsFor(joinedGround(document), plan);
  REQUIRE(grips.size() == 1);
  rig::Grip wanted;
  wanted.follower = other;
  wanted.leader = limb;
  wanted.clip = 0;
  wanted.time = {{2.0, 16.0}, {0.0, 0.0}};
  CHECK(grips[0] == wanted);
  CHECK(gripsFor(joinedGround(document, 14.0), plan)[0].time.rangeFrames == Vec2(2.0, 14.0));
}

TEST_CASE("Hands that are apart, wander or rest hold nothing together") {
  CHECK(gripsOver(swinging({}), 0.0, 20.0) == 1);
  // The farthest that hands may be apart is 0.6 of an arm: 0.4 less what both come inwards.
  const auto inwardsFor = [](double apart) { return 0.5 * pi + std::asin(0.5 * (0.4 - apart) / armReach); };
  CHECK(gripsOver(swinging({.inwards = inwardsFor(0.59 * armReach)}), 0.0, 20.0) == 1);
  CHECK(gripsOver(swinging({.inwards = inwardsFor(0.61 * armReach)}), 0.0, 20.0) == 0);
  // One that wanders by 0.04 of an arm, seen from the other.
  CHECK(gripsOver(swinging({.wanders = {0, 0, 0.036, 0, 0}}), 0.0, 20.0) == 1);
  CHECK(gripsOver(swinging({.wanders = {0, 0, 0.044, 0, 0}}), 0.0, 20.0) == 0);
  CHECK(gripsOver(swinging({.wanders = {0, 0, -0.044, 0, 0}}), 0.0, 20.0) == 0);
  CHECK(gripsOver(swinging({.wanders = {0, -0.03, 0.03, 0, 0}}), 0.0, 20.0) == 0); // To both sides.
  CHECK(gripsOver(swinging({.wanders = {0, 0, 0, 0, 0.044}}), 0.0, 20.0) == 0);
  CHECK(gripsOver(swinging({.wanders = {0.044, 0, 0, 0, 0}}), 0.0, 20.0) == 0);
  // Hands before the chest go round it by the angle: 0.3 of an arm at least.
  const double radius = armReach * std::sin(1.95);
  const auto roundFor = [&](double way) { return 2.0 * std::asin(0.5 * way / radius); };
  CHECK(gripsOver(swinging({.round = roundFor(0.31 * armReach)}), 0.0, 20.0) == 1);
  CHECK(gripsOver(swinging({.round = roundFor(0.29 * armReach)}), 0.0, 20.0) == 0);
}

TEST_CASE("Hands count as joined by what they do over the trail alone") {
  const Document document = swinging({.round = 3.0, .wanders = {0.3, 0, 0, 0, 0.3}});
  CHECK(gripsOver(document, 5.0, 15.0) == 1);
  CHECK(gripsOver(document, 4.0, 15.0) == 0);
  CHECK(gripsOver(document, 5.0, 16.0) == 0);
}

TEST_CASE("Of two trails of hands that hold on to each other the weaker one is left out, where both act") {
  const Document document = swinging({});
  const auto [start, end, isLeftOut] = GENERATE(table<double, double, bool>(
      {{4.0, 8.0, true}, {1.0, 3.0, true}, {11.0, 19.0, true}, {12.0, 19.0, false}, {0.0, 2.0, false}}));
  CAPTURE(start, end);
  AutoPlan plan =
      planOf({plannedTrail(0, "left-arm", 2.0, 10.0, 2.0), plannedTrail(1, "right-arm", start, end)});
  const std::vector<rig::Grip> grips = gripsFor(joinedGround(document), plan);
  CHECK(plan.leftOut[0].empty());
  CHECK(plan.leftOut[1] == (isLeftOut ? "its hand holds what left-arm holds, and follows it" : ""));
  REQUIRE(plan.trails.size() == (isLeftOut ? 1U : 2U));
  CHECK(plan.trails[0].trail.limb == "left-arm");
  REQUIRE_FALSE(grips.empty());
  CHECK(grips[0].leader == "left-arm");
}

TEST_CASE("Of the other hand's trails all that act at once are left out, and other limbs keep theirs") {
  const Document document = swinging({});
  AutoPlan plan = planOf({plannedTrail(0, "left-arm", 2.0, 10.0), plannedTrail(1, "right-arm", 3.0, 5.0),
                          plannedTrail(2, "spine", 2.0, 10.0), plannedTrail(3, "right-arm", 6.0, 9.0)});
  CHECK(gripsFor(joinedGround(document), plan).size() == 1);
  REQUIRE(plan.trails.size() == 2);
  CHECK(plan.trails[1].trail.limb == "spine");
  CHECK(plan.leftOut[1] == plan.leftOut[3]);
  CHECK_FALSE(plan.leftOut[1].empty());
  CHECK(plan.leftOut[2].empty());
}

TEST_CASE("Hands that are on one prop keep to that, and not to each other") {
  const Document document = swinging({});
  const auto handOn = [](const std::string& limb) {
    return rig::PropHand{limb, {{.frame = 0.0, .value = 1.0}}};
  };
  const auto gripsWith = [&](const std::vector<std::vector<rig::PropHand>>& props) {
    AutoPlan plan = planOf({plannedTrail(0, "left-arm", 2.0, 10.0)});
    for (const std::vector<rig::PropHand>& hands : props) {
      plan.holds.props.emplace_back();
      plan.holds.props.back().hands = hands;
    }
    return gripsFor(joinedGround(document), plan).size();
  };
  CHECK(gripsWith({{handOn("left-arm"), handOn("right-arm")}}) == 0);
  CHECK(gripsWith({{handOn("left-arm")}}) == 1);
  CHECK(gripsWith({{handOn("right-arm")}}) == 1);
  CHECK(gripsWith({{handOn("left-arm")}, {handOn("right-arm")}}) == 1); // Each on one of its own.
}

TEST_CASE("Only arms with both hands hold on to each other") {
  Document document = swinging({});
  CHECK(gripsOver(document, 2.0, 10.0, "spine") == 0);
  const std::size_t limb = GENERATE(0U, 1U);
  rig::Limb& hand = document.body.limbs[limb];
  hand.endNode = NodeIndex::none;
  hand.endOffset = Vec3(limb == 0 ? 0.3 : -0.3, 0.0, 0.0);
  CHECK(gripsOver(document, 2.0, 10.0) == 0);
  document.body.limbs.erase(document.body.limbs.begin() + 1);
  CHECK(gripsOver(document, 2.0, 10.0) == 0);
}

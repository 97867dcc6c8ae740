// What two hands do that swing one thing: as the stronger arm does, out and back.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/auto/planned_trail.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double swingEnd = 60.0;

/// What the stick hangs on, and whether it moves on that.
enum class Stick { shaken, onChest, onTurningHead, onMovingHead, onHand };

/// Both hands hold a stick before the chest, which swings round from frame 2 to 12, stays there until 16 and
/// is back at 20. `besideLeft`: the stick is so far from the middle, towards the left hand.
Document withStick(double besideLeft = 0.0, Stick kind = Stick::shaken) {
  Document document = test::boxer();
  Scene scene = *document.scene;
  const NodeIndex chest = findLimb(document, "spine")->endNode;
  const NodeIndex hand = findLimb(document, "left-arm")->endNode;
  const NodeIndex head = test::addNode(scene, "Head", kind == Stick::onHand ? hand : chest, {0.0, 0.0, 0.0});
  const NodeIndex stick = test::addNode(scene, "Stick", head, {besideLeft, 0.1, 0.55});
  scene.nodes[at(stick)].mesh = 0;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  Track spine = test::turnsOf(document, "spine");
  for (const auto& [frame, angle] :
       {std::pair(0, 0.0), {2, 0.0}, {12, 1.2}, {16, 1.2}, {20, 0.0}, {60, 0.0}}) {
    test::addKey(spine, frame, glm::angleAxis(angle, Vec3(0.0, 1.0, 0.0)));
  }
  Track shaken; // a little
  shaken.node = kind == Stick::shaken ? stick : head;
  shaken.channel = Channel::translation;
  shaken.width = 3;
  const Vec3 place = kind == Stick::shaken ? Vec3(besideLeft, 0.1, 0.55) : Vec3(0.0);
  const double shake = kind == Stick::shaken || kind == Stick::onMovingHead ? 0.01 : 0.0;
  for (const auto& [frame, more] : {std::pair(0.0, 0.0), {30.0, shake}, {swingEnd, 0.0}}) {
    shaken.times.push_back(static_cast<float>(frame / 30.0));
    for (const double value : {place.x, place.y, place.z + more}) {
      shaken.values.push_back(static_cast<float>(value));
    }
  }
  Track nod = test::turnsOf(document, "spine");
  nod.node = head;
  for (const auto& [frame, angle] :
       {std::pair(0, 0.0), {14, kind == Stick::onTurningHead ? 0.05 : 0.0}, {60, 0.0}}) {
    test::addKey(nod, frame, glm::angleAxis(angle, Vec3(0.0, 1.0, 0.0)));
  }
  Track left = test::turnsOf(document, "left-arm");
  Track right = test::turnsOf(document, "right-arm");
  for (const double frame : {0.0, swingEnd}) {
    test::addKey(left, frame, glm::angleAxis(0.5 * pi, Vec3(0.0, -1.0, 0.0)));
    test::addKey(right, frame, glm::angleAxis(0.5 * pi, Vec3(0.0, 1.0, 0.0)));
  }
  document = test::withTracks(std::move(document), {left, right, spine, shaken, nod});
  document.body.size = 1.8;
  return document;
}

ClipGround swingGround(const Document& document) {
  ClipGround ground{document, 0};
  ground.framesPerSecond = 30.0;
  ground.lastFrame = swingEnd;
  ground.turnFrames = swingEnd;
  ground.limbs = allLimbs(document);
  for (double frame = 0.0; frame <= swingEnd; frame += 1.0) {
    ground.places.push_back(placesOf(ground.limbs, evaluateOriginal(document, 0, frame / 30.0)));
  }
  return ground;
}

rig::Moment swingOf(const std::string& limb, double startFrame, double endFrame, double strength) {
  return {limb, rig::MomentKind::stroke, startFrame, endFrame, endFrame, strength};
}

AutoPlan planned(const Document& document, const std::vector<rig::Moment>& moments) {
  AutoSettings settings = test::in("Average");
  settings.style.spread.trunk = 0.0;
  return planTrails(swingGround(document), moments, settings, {});
}

const rig::TrailSettings& settingsAt(const AutoPlan& plan, std::size_t place) {
  REQUIRE(plan.trails.size() > place);
  return plan.trails[place].trail.settings;
}

} // namespace

TEST_CASE("The weaker of two hands on one thing goes where the stronger one does, and comes back with it") {
  const Document document = withStick();
  const auto [strong, weak] =
      GENERATE(table<std::string, std::string>({{"left-arm", "right-arm"}, {"right-arm", "left-arm"}}));
  const AutoPlan plan = planned(document, {swingOf(strong, 2, 12, 8.0), swingOf(weak, 4, 11, 4.0)});
  REQUIRE(plan.holds.props.size() == 1);
  CHECK(settingsAt(plan, 0).startFrame == 2.0);
  CHECK(settingsAt(plan, 0).endFrame == 12.0);
  CHECK(settingsAt(plan, 0).lingerFrames == 4.0); // A weak swingOf by itself is not held.
  CHECK(settingsAt(plan, 1) == settingsAt(plan, 0));
  CHECK(plan.trails[1].trail.limb == weak);
}

TEST_CASE("What hangs firmly on a body is worn, and what hangs on an arm or goes its own way is held") {
  const std::vector<rig::Moment> moments{swingOf("left-arm", 2, 12, 8.0)};
  CHECK(planned(withStick(), moments).holds.props.size() == 1);
  // On a head that turns it is worn as well; where the head goes its own way, it is held.
  CHECK(planned(withStick(0.0, Stick::onChest), moments).holds.props.empty());
  CHECK(planned(withStick(0.0, Stick::onTurningHead), moments).holds.props.empty());
  CHECK(planned(withStick(0.0, Stick::onMovingHead), moments).holds.props.size() == 1);
  CHECK(planned(withStick(0.0, Stick::onHand), moments).holds.props.size() == 1);
}

TEST_CASE("Arms are as they are by themselves where only one of them is on the thing") {
  const Document document = withStick(0.75);
  const AutoPlan plan =
      planned(document, {swingOf("left-arm", 2, 12, 8.0), swingOf("right-arm", 4, 11, 4.0)});
  REQUIRE(plan.holds.props.size() == 1);
  REQUIRE(plan.holds.props[0].hands.size() == 1);
  CHECK(settingsAt(plan, 0).lingerFrames == 4.0);
  CHECK(settingsAt(plan, 1).startFrame == 4.0);
  CHECK(settingsAt(plan, 1).endFrame == 11.0);
  CHECK(settingsAt(plan, 1).lingerFrames == 0.0);
  CHECK(settingsAt(plan, 1).scale < settingsAt(plan, 0).scale);
}

TEST_CASE("Hands on one thing swing as one where half of the shorter swingOf at least is at the same time") {
  const auto [start, end, isAtOnce] = GENERATE(table<double, double, bool>(
      {{7, 17, true}, {8, 18, false}, {9, 15, true}, {10, 15, false}, {2, 6, true}}));
  CAPTURE(start, end);
  const AutoPlan plan =
      planned(withStick(), {swingOf("left-arm", 2, 12, 8.0), swingOf("right-arm", start, end, 4.0)});
  REQUIRE(plan.trails.size() == 2);
  CHECK((settingsAt(plan, 1) == settingsAt(plan, 0)) == isAtOnce);
  CHECK((settingsAt(plan, 1).startFrame == start) == (!isAtOnce || start == 2.0));
}

TEST_CASE("One swingOf of a hand alone goes along with the other hand's, where nothing else of it is there") {
  const std::vector<rig::Moment> moments{swingOf("left-arm", 2, 12, 8.0), swingOf("right-arm", 3, 8, 5.0),
                                         swingOf("right-arm", 9, 20, 4.0)};
  const AutoPlan plan = planned(withStick(), moments);
  REQUIRE(plan.trails.size() == 3);
  CHECK(settingsAt(plan, 1).startFrame == 3.0); // A second one is in the range of the left arm's.
  CHECK(settingsAt(plan, 2).startFrame == 9.0);
  std::vector<rig::Moment> later = moments;
  later[2] = swingOf("right-arm", 40, 50, 4.0);
  const AutoPlan free = planned(withStick(), later);
  REQUIRE(free.trails.size() == 3);
  CHECK(settingsAt(free, 1) == settingsAt(free, 0));
  CHECK(settingsAt(free, 2).startFrame == 40.0);
  Document own = withStick();
  own.trails.emplace_back();
  own.trails[0].id = 1;
  own.trails[0].limb = "right-arm";
  own.trails[0].settings.startFrame = 9.0;
  own.trails[0].settings.endFrame = 14.0;
  const AutoPlan beside = planned(own, {moments[0], moments[1]});
  REQUIRE(beside.trails.size() == 2);
  CHECK(settingsAt(beside, 1).endFrame == 8.0);
}

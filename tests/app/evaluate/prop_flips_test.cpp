#include "app/evaluate/prop_flips.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/evaluate/evaluate.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

using Turns = std::vector<std::pair<double, double>>; ///< Frames, and radians about the arm.

Track turnsOfHand(const Document& document, const char* limb, const Turns& turns, double sign) {
  Track track = test::turnsOf(document, limb);
  track.node = findLimb(document, limb)->endNode;
  for (const auto& [frame, radians] : turns) {
    test::addKey(track, frame, glm::angleAxis(sign * radians, Vec3(1, 0, 0)));
  }
  return track;
}

rig::Prop inHands(const std::string& node, const std::vector<std::string>& limbs) {
  rig::Prop prop;
  prop.node = node;
  for (const std::string& limb : limbs) {
    prop.hands.push_back({limb, {{.frame = 0.0, .value = 1.0}}});
  }
  return prop;
}

const std::vector<std::string> bothArms{"left-arm", "right-arm"};

/// The boxer whose hands turn against each other by twice these angles, a stick in both.
Document wringing(const Turns& turns) {
  Document document = test::twoPunches();
  document = test::withTracks(document, {turnsOfHand(document, "left-arm", turns, 1.0),
                                         turnsOfHand(document, "right-arm", turns, -1.0)});
  document.holds.props = {inHands("Stick", bothArms)};
  return document;
}

/// Evenly from none to so many radians at frame 20.
Turns evenly(double radians) {
  Turns turns;
  for (int i = 0; i <= 8; ++i) {
    turns.emplace_back(2.5 * i, radians * i / 8.0);
  }
  return turns;
}

std::vector<PropFlip> flipsOf(const Document& document, int clip = 0) {
  return propFlips(document, prepareMotion(document, clip));
}

constexpr double oneDegree = pi / 180.0;

} // namespace

TEST_CASE("A prop between hands that are turned by half a turn against each other turns over there") {
  // Each hand turns by 8.5 degrees in a frame and is turned by 90 after 10.59 of them.
  const std::vector<PropFlip> flips = flipsOf(wringing(evenly(170.0 * oneDegree)));
  REQUIRE(flips.size() == 1);
  CHECK(flips[0].prop == "Stick");
  CHECK(flips[0].frame == 11.0);
  CHECK(flips[0].degrees == Approx(180.0).margin(0.5));
}

TEST_CASE("A prop between hands that come to less than half a turn does not turn over") {
  CHECK(flipsOf(wringing(evenly(85.0 * oneDegree))).empty());
  CHECK(flipsOf(wringing({{0.0, 0.0}, {20.0, 0.0}})).empty());
}

TEST_CASE("Hands that turn by a third of it as fast explain how a prop turns") {
  // The hands pass half a turn within half a frame, by so much each: 45 degrees and three times that is 180
  // at 45.
  const auto flipsBy = [](double degrees) {
    const double half = 0.5 * degrees;
    return flipsOf(wringing({{0.0, 0.0},
                             {5.0, 45.0 * oneDegree},
                             {9.5, (90.0 - half) * oneDegree},
                             {10.0, (90.0 + half) * oneDegree},
                             {20.0, (91.0 + half) * oneDegree}}))
        .size();
  };
  CHECK(flipsBy(40.0) == 1);
  CHECK(flipsBy(50.0) == 0);
}

TEST_CASE("The worst turn of a prop is told, and that of each prop") {
  Document document = wringing(evenly(170.0 * oneDegree));
  Scene scene = *document.scene;
  test::addNode(scene, "", NodeIndex::none, {0.1, 0.5, 0.5});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const NodeIndex last(document.scene->nodes.size() - 1);
  const std::string unnamed = "#" + std::to_string(last.value);
  document.holds.props = {inHands(unnamed, {"left-arm"}), inHands("Stick", {"right-arm"})};
  CHECK(flipsOf(document).empty()); // In one hand each.
  document.holds.props = {inHands("Stick", {"left-arm"}), inHands(unnamed, bothArms)};
  const std::vector<PropFlip> flips = flipsOf(document);
  REQUIRE(flips.size() == 1);
  CHECK(flips[0].prop == unnamed);
  CHECK(flips[0].frame == 11.0);
}

TEST_CASE("A prop of another clip is looked at in that clip alone") {
  Document document = wringing(evenly(170.0 * oneDegree));
  std::vector<Clip> clips = *document.clips;
  clips.insert(clips.begin(), clips[0]);
  clips[0].tracks.resize(1);
  clips[0].tracks[0] = CopyOnWrite<Track>(turnsOfHand(document, "left-arm", {{0.0, 0.0}, {20.0, 0.0}}, 1.0));
  document.clips = std::make_shared<const std::vector<Clip>>(clips);
  document.holds.props[0].clip = 1;
  CHECK(flipsOf(document, 0).empty());
  CHECK(flipsOf(document, 1).size() == 1);
  document.holds.props[0].clip = 0;
  CHECK(flipsOf(document, 0).empty());
  CHECK(flipsOf(document, 1).empty());
}

TEST_CASE("A prop that turns over is told with its name, how far, where, and the way out") {
  CHECK(flipWarning({"Stick", 10.5, 178.6}) ==
        "the prop \"Stick\" turns over by 179 degrees at frame 10.5: its hands are turned against each other "
        "there "
        "by half a turn; let one hand hold it more firmly from a frame before");
}

// What looks wrong of all trails of a clip together, each at the edge from which on it does, and which trail
// is told.
#include "app/auto/whole_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "rig/trail/release.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double bodyHeight = 1.8;
constexpr double unseen = 0.004 * bodyHeight;
constexpr double reachOfArm = 0.6;
constexpr double handsAt = 1.5;

/// A style that lets limbs be as long and as short as they like.
AutoSettings lettingAll() {
  AutoSettings settings;
  for (rig::ScaleRange* range :
       {&settings.style.arm, &settings.style.leg, &settings.style.torso, &settings.style.other}) {
    *range = {0.0, 1.0, 9.0};
  }
  return settings;
}

/// A trail whose limb's end is pulled so far at its tip.
PlannedTrail pulled(const std::string& limb, double startFrame, double endFrame, const Vec3& offset) {
  PlannedTrail planned;
  rig::Trail& trail = planned.trail;
  trail.limb = limb;
  trail.exaggerated = trail.connected = true;
  trail.settings.startFrame = startFrame;
  trail.settings.endFrame = endFrame;
  trail.settings.releaseFrames = 3.0;
  trail.settings.spheres = {{endFrame, offset, {}}};
  return planned;
}

AutoPlan planWith(std::vector<PlannedTrail> trails) {
  AutoPlan plan;
  plan.leftOut.resize(trails.size());
  plan.trails = std::move(trails);
  return plan;
}

std::vector<std::pair<std::size_t, FaultKind>> faultsIn(const Document& document, const AutoPlan& plan,
                                                        const AutoSettings& settings = lettingAll()) {
  std::vector<std::pair<std::size_t, FaultKind>> found;
  for (const Fault& fault : faultsOf(clipGround(document, 0), settings, plan)) {
    found.emplace_back(fault.trail, fault.kind);
  }
  return found;
}

/// The one fault of a plan of one trail.
std::optional<FaultKind> faultOf(const Document& document, const PlannedTrail& trail,
                                 const AutoSettings& settings = lettingAll()) {
  const auto found = faultsIn(document, planWith({trail}), settings);
  CHECK(found.size() <= 1);
  return found.empty() ? std::nullopt : std::optional(found[0].second);
}

using Faults = std::vector<std::pair<std::size_t, FaultKind>>;

/// Arms out to the sides that keep still.
Document armsOut() {
  const Document start = test::boxer();
  Track arm = test::turnsOf(start, "left-arm");
  for (const double frame : {0.0, 20.0}) {
    test::addKey(arm, frame, Quat(1.0, 0.0, 0.0, 0.0));
  }
  return test::withTracks(start, {arm});
}

/// Arms ahead, so far apart at the hands.
Document handsAhead(double apart) {
  const Document start = test::boxer();
  std::vector<Track> tracks;
  const double inwards = 0.5 * pi + std::asin(0.5 * (0.4 - apart) / reachOfArm);
  for (const bool isLeft : {true, false}) {
    tracks.push_back(test::turnsOf(start, isLeft ? "left-arm" : "right-arm"));
    for (const double frame : {0.0, 20.0}) {
      test::addKey(tracks.back(), frame, glm::angleAxis(inwards, Vec3(0.0, isLeft ? -1.0 : 1.0, 0.0)));
    }
  }
  return test::withTracks(start, std::move(tracks));
}

} // namespace

TEST_CASE("A limb longer than the style lets it be by more than is seen is a fault, one as long is none",
          "[whole]") {
  AutoSettings settings = lettingAll();
  settings.style.arm.most = 1.5;
  const auto withLength = [&](double length) {
    return faultOf(armsOut(), pulled("left-arm", 2, 8, Vec3(length - reachOfArm, 0.0, 0.0)), settings);
  };
  CHECK_FALSE(withLength(1.5 * reachOfArm));
  CHECK_FALSE(withLength(1.5 * reachOfArm + 0.9 * unseen));
  CHECK(withLength(1.5 * reachOfArm + 1.1 * unseen) == FaultKind::lengths);
  settings.style.leg.most = settings.style.torso.most = settings.style.other.most = 1.0;
  CHECK_FALSE(withLength(1.5 * reachOfArm));
}

TEST_CASE("A limb shorter than two thirds of what the style squashes it to is a fault", "[whole]") {
  const double least = GENERATE(0.75, 1.0, 1.4);
  AutoSettings settings = lettingAll();
  settings.style.arm.least = least;
  const double shortest = std::min(1.0, least) * reachOfArm / 1.5;
  const auto withLength = [&](double length) {
    return faultOf(armsOut(), pulled("left-arm", 2, 8, Vec3(length - reachOfArm, 0.0, 0.0)), settings);
  };
  CAPTURE(least);
  CHECK_FALSE(withLength(shortest - 0.9 * unseen));
  CHECK(withLength(shortest - 1.1 * unseen) == FaultKind::lengths);
}

TEST_CASE("A limb may not go lower than anything in the clip does, its middle no more than its end",
          "[whole]") {
  const Document document = armsOut(); // The spine begins at 1.2.
  const auto lowered = [&](const char* limb, double height) {
    return faultOf(document, pulled(limb, 2, 8, Vec3(0.0, height - handsAt, 0.0)));
  };
  for (const char* const limb : {"left-arm", "right-arm"}) {
    CHECK_FALSE(lowered(limb, 1.2 - 0.9 * unseen));
    CHECK(lowered(limb, 1.2 - 1.1 * unseen) == FaultKind::floor);
  }
  // The right arm hangs lower: the left one may go as deep.
  Document hanging = document;
  Track right = test::turnsOf(document, "right-arm");
  for (const double frame : {0.0, 20.0}) {
    test::addKey(right, frame, glm::angleAxis(1.2, Vec3(0.0, 0.0, 1.0)));
  }
  hanging = test::withTracks(document, {right});
  const double low = handsAt - reachOfArm * std::sin(1.2);
  const auto lowest = [&](double height) {
    return faultOf(hanging, pulled("left-arm", 2, 8, Vec3(0.0, height - handsAt, 0.0)));
  };
  CHECK_FALSE(lowest(low - 0.9 * unseen));
  CHECK(lowest(low - 1.1 * unseen) == FaultKind::floor);
}

TEST_CASE("What hangs on a limb may not go through the ground, nor may what is carried with it", "[whole]") {
  Document document = armsOut();
  Scene scene = *document.scene;
  Primitive primitive;
  primitive.positions = {{0.0F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}, {0.0F, 0.1F, 0.0F}};
  primitive.indices = {0, 1, 2};
  scene.meshes.push_back({"Weight", {primitive}, {}});
  const NodeIndex weight =
      test::addNode(scene, "Weight", findLimb(document, "left-arm")->endNode, {0.0, -0.4, 0.0});
  scene.nodes[at(weight)].mesh = 0;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const auto lowered = [&](const char* limb, double by) {
    return faultOf(document, pulled(limb, 2, 8, Vec3(0.0, -by, 0.0)));
  };
  const double margin = 0.001 * bodyHeight; // The weight is the lowest of all in the clip.
  CHECK_FALSE(lowered("left-arm", 0.5 * margin));
  CHECK(lowered("left-arm", 0.05) == FaultKind::floor);
  CHECK_FALSE(lowered("right-arm", 0.05));
}

TEST_CASE("A foot that stands may not be moved, one in the air may", "[whole]") {
  const Document document = test::stepper();
  const ClipGround ground = clipGround(document, 0);
  REQUIRE(ground.standsOf("left-leg").size() == 2);
  const double leaves = ground.standsOf("left-leg").front().y;
  const double comes = ground.standsOf("left-leg").back().x;
  const auto moved = [&](double startFrame, double endFrame, double way) {
    PlannedTrail trail = pulled("left-leg", startFrame, endFrame, Vec3(0.0, way, way));
    trail.trail.settings.releaseFrames = 2.0;
    return faultOf(document, trail);
  };
  CHECK_FALSE(moved(leaves + 1.0, leaves + 6.0, 0.1));
  CHECK(moved(leaves - 6.0, leaves, 0.1) == FaultKind::stand);
  CHECK(moved(leaves - 8.0, leaves - 3.0, 0.1) == FaultKind::stand);
  CHECK(moved(comes - 6.0, comes, 0.1) == FaultKind::stand);
  CHECK_FALSE(moved(comes - 10.0, comes - 4.0, 0.1));
  CHECK_FALSE(moved(leaves - 6.0, leaves, 0.9 * unseen / std::sqrt(2.0)));
}

TEST_CASE("Limbs of one chain may not pull opposite ways while both act", "[whole]") {
  const Document document = armsOut();
  const auto faults = [&](double degrees, double startFrame, bool armFirst) {
    const double angle = degrees * pi / 180.0;
    const PlannedTrail spine = pulled("spine", 2, 8, Vec3(0.0, 0.0, 0.02));
    const PlannedTrail arm =
        pulled("left-arm", startFrame, startFrame + 4.0, 0.02 * Vec3(0.0, std::sin(angle), std::cos(angle)));
    return faultsIn(document, planWith(armFirst ? std::vector{arm, spine} : std::vector{spine, arm}));
  };
  const bool armFirst = GENERATE(true, false);
  CHECK(faults(0.0, 3.0, armFirst).empty());
  CHECK(faults(105.0, 3.0, armFirst).empty());                          // Its cosine is -0.26,
  CHECK(faults(110.0, 3.0, armFirst) == Faults{{1, FaultKind::chain}}); // and -0.34.
  CHECK(faults(180.0, 3.0, armFirst) == Faults{{1, FaultKind::chain}});
  CHECK(faults(180.0, 10.5, armFirst) == Faults{{1, FaultKind::chain}}); // On the way back of the spine.
  CHECK(faults(180.0, 11.0, armFirst).empty());
}

TEST_CASE("The ways of a chain's limbs are those of their own trails, wherever those stand in the plan",
          "[whole]") {
  // The left arm is held up and goes to its left, against the spine, which bends to the right; the right arm,
  // out to its side, goes down, along neither.
  const Document start = test::boxer();
  std::vector<Track> tracks;
  for (const auto& [limb, at, by] :
       {std::tuple("left-arm", 0.5 * pi, 0.35), {"right-arm", 0.0, -0.35}, {"spine", 0.0, -0.05}}) {
    tracks.push_back(test::turnsOf(start, limb));
    for (const auto& [frame, angle] : {std::pair(0.0, by), {10.0, 0.0}, {20.0, by}}) {
      test::addKey(tracks.back(), frame, glm::angleAxis(at + angle, Vec3(0.0, 0.0, 1.0)));
    }
  }
  const Document document = test::withTracks(start, std::move(tracks));
  const auto scaled = [](const std::string& limb) {
    PlannedTrail trail = pulled(limb, 2, 8, Vec3(0.0));
    trail.trail.settings.spheres.clear();
    trail.trail.settings.scale = 1.1;
    return trail;
  };
  std::vector<std::string> order{"left-arm", "right-arm", "spine"};
  do {
    std::vector<PlannedTrail> trails;
    std::ranges::transform(order, std::back_inserter(trails), scaled);
    const auto later = [&](const std::string& limb) {
      return static_cast<std::size_t>(std::ranges::find(order, limb) - order.begin());
    };
    CAPTURE(order);
    for (const auto& [where, kind] : faultsIn(document, planWith(trails))) {
      UNSCOPED_INFO("of " << where << ": " << textOf(kind));
    }
    CHECK(faultsIn(document, planWith(trails)) ==
          Faults{{std::max(later("left-arm"), later("spine")), FaultKind::chain}});
  } while (std::ranges::next_permutation(order).found);
}

TEST_CASE("Limbs that do not carry each other may pull opposite ways", "[whole]") {
  CHECK(faultsIn(armsOut(), planWith({pulled("left-arm", 2, 8, Vec3(0.0, 0.0, 0.2)),
                                      pulled("right-arm", 2, 8, Vec3(0.0, 0.0, -0.2))}))
            .empty());
}

TEST_CASE("Hands that are near each other may not change sides", "[whole]") {
  const double apart = 0.1;
  const Document document = handsAhead(apart);
  const auto across = [&](const char* limb, double way, double up) {
    return faultOf(document, pulled(limb, 2, 8, Vec3(way, up, 0.0)));
  };
  const double seen = unseen; // Along the line between the shoulders.
  CHECK_FALSE(across("left-arm", -apart - 0.9 * seen, 0.0));
  CHECK(across("left-arm", -apart - 1.1 * seen, 0.0) == FaultKind::sides);
  CHECK(across("right-arm", apart + 1.1 * seen, 0.0) == FaultKind::sides);
  CHECK_FALSE(across("right-arm", -apart - 1.1 * seen, 0.0)); // Away from each other.
  // They pass each other where half of an arm is between them.
  CHECK(across("left-arm", -apart - 2.0 * seen, 0.49 * reachOfArm) == FaultKind::sides);
  CHECK_FALSE(across("left-arm", -apart - 2.0 * seen, 0.51 * reachOfArm));
}

TEST_CASE("Hands that hold on to each other or to one thing change sides as that does", "[whole]") {
  const Document document = handsAhead(0.1);
  AutoPlan plan = planWith({pulled("left-arm", 2, 8, Vec3(-0.15, 0.0, 0.0))});
  REQUIRE(faultsIn(document, plan) == Faults{{0, FaultKind::sides}});
  rig::Grip grip;
  grip.time = {{15.0, 20.0}, {0.0, 0.0}}; // It does not act there.
  const bool isLeft = GENERATE(true, false);
  grip.leader = isLeft ? "left-arm" : "right-arm";
  grip.follower = isLeft ? "right-arm" : "left-arm";
  plan.holds.grips = {grip};
  CHECK(faultsIn(document, plan).empty());
}

TEST_CASE("A limb that goes along with another one, by the hand or by a thing, is as long as that makes it",
          "[whole]") {
  AutoSettings settings = lettingAll();
  settings.style.arm.most = 1.5;
  Document document = armsOut();
  Scene scene = *document.scene;
  test::addNode(scene, "Stick", NodeIndex::none, {0.0, handsAt, 0.0});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  AutoPlan plan = planWith({pulled("left-arm", 2, 8, Vec3(-0.7, 0.0, 0.0))});
  REQUIRE(faultsIn(document, plan, settings).empty());
  SECTION("one hand holds the other") {
    rig::Grip grip;
    grip.time = {{0.0, 20.0}, {0.0, 0.0}};
    grip.leader = "left-arm";
    grip.follower = "right-arm";
    plan.holds.grips = {grip};
  }
  SECTION("both hold a stick, which goes half the way") {
    rig::OffsetKey firm;
    firm.value = 1.0;
    rig::Prop stick;
    stick.node = "Stick";
    stick.hands = {{"left-arm", {firm}}, {"right-arm", {firm}}};
    plan.holds.props = {stick};
  }
  CHECK(faultsIn(document, plan, settings) == Faults{{0, FaultKind::lengths}});
}

TEST_CASE("Of several trails that move a limb the weakest is told without which nothing is wrong",
          "[whole]") {
  const Document document = armsOut();
  const double room = handsAt - 1.2;
  const auto lowering = [](const char* limb, double startFrame, double by) {
    return pulled(limb, startFrame, startFrame + 6.0, Vec3(0.0, -by, 0.0));
  };
  CHECK(faultsIn(document, planWith({lowering("left-arm", 2.0, room + 0.1),
                                     lowering("right-arm", 2.0, 0.1)})) == Faults{{0, FaultKind::floor}});
  CHECK(faultsIn(document,
                 planWith({lowering("right-arm", 2.0, 0.1), lowering("left-arm", 2.0, room + 0.1)})) ==
        Faults{{1, FaultKind::floor}});
  CHECK(faultsIn(document,
                 planWith({lowering("left-arm", 0.0, room + 0.1), lowering("left-arm", 10.0, room + 0.1)})) ==
        Faults{{0, FaultKind::floor}, {1, FaultKind::floor}});
  CHECK(faultsIn(document, planWith({lowering("left-arm", 0.0, room + 0.1),
                                     lowering("left-arm", 10.0, 0.1)})) == Faults{{0, FaultKind::floor}});
}

TEST_CASE("Each kind of fault has words of its own", "[whole]") {
  std::vector<std::string> words;
  for (const FaultKind kind : {FaultKind::lengths, FaultKind::floor, FaultKind::stand, FaultKind::chain,
                               FaultKind::seam, FaultKind::sides, FaultKind::lifted}) {
    words.emplace_back(textOf(kind));
  }
  const std::vector<std::string> told = words;
  std::ranges::sort(words);
  CHECK(std::ranges::adjacent_find(words) == words.end());
  CHECK_THAT(told[0], Catch::Contains("lengths"));
  CHECK_THAT(told[1], Catch::Contains("floor"));
  CHECK_THAT(told[2], Catch::Contains("foot"));
  CHECK_THAT(told[3], Catch::Contains("chain"));
  CHECK_THAT(told[4], Catch::Contains("loop"));
  CHECK_THAT(told[5], Catch::Contains("other side"));
  CHECK_THAT(told[6], Catch::Contains("ground"));
}

// The inner side of every bound of a hold and an offset, and faults that only a later one of several has.
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/things/place.h"
#include "core/math/types.h"
#include "core/scene/camera.h"
#include "tests/support/app/standing_leg.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/nodes.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

template <typename T>
using Change = std::function<void(T&)>;

/// What a thing of twoPunches is refused with after a change, in a document.
template <typename T>
std::string refusalAfter(const Change<T>& change, const Document& document = test::twoPunches(),
                         std::size_t which = 0) {
  const Things all = test::oneOfEach(0, 0.5);
  T thing = listOf<T>(all)[which];
  change(thing);
  return test::refusal(placeOf<T>(document, {thing}, Entry::request));
}

template <typename T>
void checkAllowed(const std::vector<Change<T>>& changes, std::size_t which = 0) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(i);
    CHECK(refusalAfter<T>(changes[i], test::twoPunches(), which) == "accepted");
  }
}

/// Times at the edge of what a hold may have.
template <typename T, typename TimeOf>
std::vector<Change<T>> edgeTimes(const TimeOf& timeOf) {
  return {[=](T& hold) { timeOf(hold).rangeFrames = Vec2(0.0, 20.0); },
          [=](T& hold) { timeOf(hold).rangeFrames = Vec2(7.0, 7.0); },
          [=](T& hold) { timeOf(hold).rangeFrames = Vec2(-4.0, 0.0); },
          [=](T& hold) { timeOf(hold).rangeFrames = Vec2(20.0, 20.0); },
          [=](T& hold) { timeOf(hold).blendFrames = Vec2(0.0, 0.0); },
          [=](T& hold) { timeOf(hold).blendFrames = Vec2(1e6, 0.0); },
          [=](T& hold) { timeOf(hold).blendFrames = Vec2(0.0, 1e6); },
          [=](T& hold) { hold.clip = 1; },
          [=](T& hold) { hold.stretch = 0.0; },
          [=](T& hold) { hold.stretch = 1.0; }};
}

Change<rig::Pin> placedAt(const Vec3& position, double quaternionLength = 1.0) {
  return [=](rig::Pin& pin) { pin.place = rig::HeldPlace{position, Quat(quaternionLength, 0.0, 0.0, 0.0)}; };
}

rig::OffsetKey keyAt(double frame, double value) {
  rig::OffsetKey key;
  key.frame = frame;
  key.value = value;
  return key;
}

/// The document with its scene changed.
Document withScene(const std::function<void(Scene&)>& change) {
  Document document = test::twoPunches();
  Scene scene = *document.scene;
  change(scene);
  document.scene = std::make_shared<const Scene>(std::move(scene));
  return document;
}

} // namespace

TEST_CASE("A pin at the edge of what it may be is let in") {
  using rig::Pin;
  checkAllowed(edgeTimes<Pin>([](Pin& pin) -> rig::HoldTime& { return pin.time; }));
  checkAllowed<Pin>({[](Pin& pin) { pin.atFrame = 0.0; }, [](Pin& pin) { pin.atFrame = 20.0; },
                     [](Pin& pin) { pin.limb = "left-arm"; }, placedAt({0.0, 1799.0, 0.0}),
                     placedAt({0.0, 0.0, -1799.0}), placedAt(Vec3(0.0), 0.51), placedAt(Vec3(0.0), 1.99)});
  CHECK(refusalAfter<Pin>(placedAt(Vec3(0.0), 0.49)).find("its place is not finite") != std::string::npos);
  CHECK(refusalAfter<Pin>(placedAt(Vec3(0.0), 2.01)).find("its place is not finite") != std::string::npos);
}

TEST_CASE("A grip at the edge of what it may be is let in") {
  using rig::Grip;
  checkAllowed(edgeTimes<Grip>([](Grip& grip) -> rig::HoldTime& { return grip.time; }));
  checkAllowed<Grip>({[](Grip& grip) { grip.relationFrame.reset(); },
                      [](Grip& grip) { grip.relationFrame = 0.0; },
                      [](Grip& grip) { grip.relationFrame = 20.0; },
                      [](Grip& grip) { std::swap(grip.leader, grip.follower); }});
}

TEST_CASE("A prop at the edge of what it may be is let in") {
  using rig::Prop;
  checkAllowed(edgeTimes<Prop>([](Prop& prop) -> rig::HoldTime& {
    return prop.time ? *prop.time : prop.time.emplace(rig::HoldTime{{3.0, 12.0}, {0.0, 0.0}});
  }));
  checkAllowed<Prop>({[](Prop& prop) { prop.time.reset(); }, [](Prop& prop) { prop.boundFrame.reset(); },
                      [](Prop& prop) { prop.boundFrame = 20.0; }, [](Prop& prop) { prop.boundFrame = 0.0; },
                      [](Prop& prop) {
                        prop.hands[0].keys = {keyAt(0.0, 0.0), keyAt(0.5, 1.0)};
                      },
                      [](Prop& prop) {
                        prop.hands.push_back({"right-arm", {keyAt(8.0, 1.0)}});
                      },
                      [](Prop& prop) { prop.move = Vec3(0.0, -1799.0, 0.0); },
                      [](Prop& prop) { prop.turn = Vec3(0.0, 0.0, 628.0); }});
}

TEST_CASE("A fault of a later hand or a later key of a prop is found, and told by its hand") {
  using rig::Prop;
  const auto second = [](const std::string& limb, const std::vector<rig::OffsetKey>& keys) {
    return refusalAfter<Prop>([=](Prop& prop) { prop.hands.push_back({limb, keys}); });
  };
  using Catch::StartsWith;
  CHECK_THAT(second("tail", {keyAt(8.0, 1.0)}), StartsWith("tail: the character has no hand or foot"));
  CHECK_THAT(second("right-arm", {}), StartsWith("Stick.right-arm: the hand is named twice, or has no keys"));
  CHECK_THAT(second("right-arm", {keyAt(1.0, 1.0), keyAt(2.0, 1.5)}),
             StartsWith("Stick.right-arm: the value at frame 2 is out of range"));
  CHECK_THAT(second("right-arm", {keyAt(1.0, 1.0), keyAt(3.0, 1.0), keyAt(3.0005, 1.0)}),
             StartsWith("Stick.right-arm: two keys stand at frame 3.0005"));
  CHECK_THAT(second("right-arm", {keyAt(3.0, 1.0), keyAt(1.0, 1.0)}),
             StartsWith("Stick.right-arm: two keys stand at frame 1"));
  CHECK_THAT(refusalAfter<Prop>([](Prop& prop) { prop.hands[0].keys[0].valueSlope = INFINITY; }),
             StartsWith("Stick.left-arm: the value at frame 8 is out of range"));
}

TEST_CASE("What the body hangs on, and what its skin is drawn by, is no thing to hold") {
  using rig::Prop;
  const auto inScene = [](const std::function<void(Scene&)>& change, const std::string& node) {
    return refusalAfter<Prop>([&](Prop& prop) { prop.node = node; }, withScene(change));
  };
  using Catch::StartsWith;
  CHECK_THAT(inScene([](Scene& scene) { scene.nodes.back().skin = 0; }, "Stick"),
             StartsWith("Stick: holds a skinned mesh, which its joints move and not the node"));
  for (const char* const part : {"Chest", "LeftHand", "LeftArm", "RightHand", "Spine"}) {
    CHECK_THAT(inScene([](Scene& /*scene*/) {}, part),
               StartsWith(std::string(part) + ": is part of the body"));
  }
  const auto carry = [](Scene& scene) {
    const NodeIndex root = test::addNode(scene, "Root", NodeIndex::none, Vec3(0.0));
    scene.nodes[at(scene.nodes[0].parent = root)].children = {NodeIndex(0)};
    std::erase(scene.roots, NodeIndex(0));
  };
  CHECK_THAT(inScene(carry, "Root"), StartsWith("Root: is part of the body, or carries the hand"));
  CHECK(inScene([](Scene& scene) { test::addNode(scene, "Ring", NodeIndex(5), Vec3(0.1)); }, "Ring") ==
        "accepted");
}

TEST_CASE("Grips lead in a circle only while they act together, however many are between") {
  const auto placed = [](const std::vector<std::pair<Vec2, double>>& times) {
    std::vector<rig::Grip> grips;
    for (const auto& [range, blend] : times) {
      rig::Grip grip;
      const bool isOdd = grips.size() % 2 == 1;
      grip.follower = isOdd ? "left-arm" : "right-arm";
      grip.leader = isOdd ? "right-arm" : "left-arm";
      grip.time = {range, Vec2(blend, blend)};
      grips.push_back(grip);
    }
    return test::refusal(placeOf<rig::Grip>(test::twoPunches(), grips, Entry::request));
  };
  using Catch::Contains;
  CHECK(placed({{{0.0, 4.0}, 0.0}, {{8.0, 12.0}, 0.0}}) == "accepted");
  CHECK_THAT(placed({{{0.0, 8.0}, 0.0}, {{4.0, 12.0}, 0.0}}), Contains("grips lead in a circle: "));
  CHECK_THAT(placed({{{0.0, 4.0}, 6.0}, {{8.0, 12.0}, 0.0}}), Contains("grips lead in a circle: "));
  CHECK_THAT(placed({{{0.0, 4.0}, 0.0}, {{8.0, 12.0}, 6.0}}), Contains("grips lead in a circle: "));
}

TEST_CASE("Grips of three limbs lead in a circle where each follows the next at one time") {
  Document document = test::twoPunches();
  test::addStandingLeg(document);
  const auto grip = [](const char* follower, const char* leader, const Vec2& range) {
    rig::Grip made;
    made.follower = follower;
    made.leader = leader;
    made.time = {range, Vec2(0.0)};
    return made;
  };
  const auto placedWith = [&](const rig::Grip& third) {
    const std::vector<rig::Grip> grips{grip("right-arm", "left-arm", {0.0, 8.0}),
                                       grip("left-leg", "right-arm", {0.0, 8.0}), third};
    return test::refusal(placeOf<rig::Grip>(document, grips, Entry::request));
  };
  CHECK_THAT(placedWith(grip("left-arm", "left-leg", {4.0, 12.0})),
             Catch::StartsWith("right-arm: grips lead in a circle: right-arm follows left-arm"));
  CHECK(placedWith(grip("left-arm", "left-leg", {12.0, 16.0})) == "accepted");
}

TEST_CASE("Offsets and values at the edge of what they may be are let in") {
  using rig::Adjustment;
  checkAllowed<Adjustment>({[](Adjustment& hips) { hips.keys[0].move.x = 1799.0; },
                            [](Adjustment& hips) { hips.keys[0].moveSlope.x = -1799.0; },
                            [](Adjustment& hips) { hips.keys[0].turn.x = 628.0; },
                            [](Adjustment& hips) { hips.keys[0].turnSlope.x = -628.0; },
                            [](Adjustment& hips) { hips.keys[0].frame = 2.0; },
                            [](Adjustment& hips) { hips.keys[0].frame = 16.0; },
                            [](Adjustment& hips) { hips.rangeFrames.reset(); },
                            [](Adjustment& hips) { hips.keys.push_back(keyAt(9.0, 0.0)); }});
  constexpr std::size_t attribute = 1; // in oneOfEach
  checkAllowed<Adjustment>({[](Adjustment& arm) { arm.keys[0].value = 999.0; },
                            [](Adjustment& arm) { arm.keys[0].value = -999.0; },
                            [](Adjustment& arm) { arm.keys[0].valueSlope = -999.0; }},
                           attribute);
  CHECK_THAT(refusalAfter<Adjustment>([](Adjustment& hips) {
               hips.keys.push_back(keyAt(9.0, 0.0));
               hips.keys[1].move.z = 1801.0;
             }),
             Catch::StartsWith("hips: the offset at frame 9 is out of proportion"));
}

TEST_CASE("A trail at the edge of the clip, or judged by a view, is let in") {
  using rig::Trail;
  const auto over = [](double first, double last) -> Change<Trail> {
    return [=](Trail& trail) {
      trail.settings.startFrame = first;
      trail.settings.endFrame = last;
    };
  };
  checkAllowed<Trail>({over(19.5, 25.0), over(-5.0, 0.5), over(-3.0, 30.0),
                       [](Trail& trail) { trail.settings.sight.camera = "front"; },
                       [](Trail& trail) {
                         trail.settings.sight.camera = "three-quarter";
                         trail.settings.sight.asSeen = true;
                       },
                       [](Trail& trail) {
                         trail.settings.sight.view = cameraFrom(Vec3(1.0, 0.0, 0.0));
                         trail.settings.sight.turnDegrees = 10.0;
                       }});
}

TEST_CASE("A file keeps trails that other programs left without a clip's frames or without their camera") {
  using rig::Trail;
  const auto inFile = [](const Change<Trail>& change) {
    Trail trail = test::oneOfEach(0, 0.5).trails.front();
    change(trail);
    return test::refusal(placeOf<Trail>(test::twoPunches(), {trail}, Entry::file));
  };
  CHECK(inFile([](Trail& trail) {
          trail.settings.startFrame = 30.0;
          trail.settings.endFrame = 40.0;
        }) == "accepted");
  CHECK(inFile([](Trail& trail) { trail.settings.sight.camera = "Shot"; }) == "accepted");
  CHECK(inFile([](Trail& trail) { trail.settings.sight.turnDegrees = 10.0; }) == "accepted");
  CHECK_THAT(inFile([](Trail& trail) { trail.settings.sight.asSeen = true; }),
             Catch::StartsWith("left-arm: the scale counts as seen, by no camera"));
}

TEST_CASE("A trail keeps the number that it brings, others get the next ones, and none is given twice") {
  rig::Trail first = test::oneOfEach(0, 0.5).trails.front();
  first.id = 7;
  rig::Trail second = first;
  second.id = 0;
  second.limb = "right-arm";
  const Result<Placed> two = placeOf<rig::Trail>(test::twoPunches(), {first, second}, Entry::request);
  REQUIRE(two);
  CHECK(two->trailIds == std::vector<int>{7, 8});
  CHECK(two->document.nextTrailId == 9);
  rig::Trail early = second;
  early.id = 3;
  early.limb = "spine";
  const Result<Placed> third = placeOf<rig::Trail>(two->document, {early}, Entry::request);
  REQUIRE(third);
  CHECK(third->trailIds == std::vector<int>{3});
  CHECK(third->document.nextTrailId == 9);
}

TEST_CASE("A limb's new weight stands where its old one stood, so that reports keep their order") {
  const auto weightOf = [](const char* limb, double amount) {
    WeightedLimb weight;
    weight.limb = limb;
    weight.settings.amount = amount;
    return weight;
  };
  const Result<Placed> both = placeOf<WeightedLimb>(
      test::twoPunches(), {weightOf("left-arm", 0.5), weightOf("right-arm", 0.5)}, Entry::request);
  REQUIRE(both);
  const Result<Placed> changed =
      placeOf<WeightedLimb>(both->document, {weightOf("left-arm", 0.25)}, Entry::request);
  REQUIRE(changed);
  CHECK(changed->document.weights ==
        std::vector<WeightedLimb>{weightOf("left-arm", 0.25), weightOf("right-arm", 0.5)});
  CHECK(test::refusal(placeOf<WeightedLimb>(both->document, {weightOf("left-arm", 0.25)}, Entry::hand)) ==
        "left-arm: the limb is named twice; name it once");
}

#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/pose/hold_text.h"
#include "app/commands/pose/step_text.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// What the step says beside its label; the label alone says nothing.
std::string toldBy(const Document& before, const Document& after, const std::string& label = "Step") {
  const std::string text = stepText(label, before, after);
  const std::string between = label + " \xE2\x80\x93 ";
  CHECK((text == label || text.starts_with(between)));
  return text == label ? std::string() : text.substr(between.size());
}

using TrailChange = std::function<void(rig::TrailSettings&)>;

Document withSettings(Document document, const TrailChange& change, std::size_t trail = 0) {
  change(document.trails[trail].settings);
  return document;
}

/// A trail of the left arm over the frames 0 to 10, at scale 2.
Document withArmTrail() {
  return test::withNewTrail(test::boxer(), {});
}

std::string ofChange(const TrailChange& change) {
  return toldBy(withArmTrail(), withSettings(withArmTrail(), change));
}

Document withKeys(const Document& document, const std::string& controller,
                  const std::vector<std::pair<double, double>>& keys) {
  rig::Adjustment adjustment;
  adjustment.controller = controller;
  for (const auto& [frame, up] : keys) {
    adjustment.keys.push_back({.frame = frame, .move = {0.0, up, 0.0}});
  }
  const Result<Document> placed = placeAdjustments(document, {&adjustment, 1});
  REQUIRE(placed);
  return *placed;
}

Document withWeight(const Document& document, const std::function<void(WeightSettings&)>& change) {
  WeightedLimb arm{"right-arm", 0, true, {}};
  change(arm.settings);
  const Result<Document> changed = setWeight(document, arm);
  REQUIRE(changed);
  return *changed;
}

rig::Pin pinOf(const std::string& limb, double first, double last) {
  rig::Pin pin;
  pin.limb = limb;
  pin.time.rangeFrames = Vec2(first, last);
  return pin;
}

Document withPins(const std::vector<rig::Pin>& pins) {
  Document document = test::boxer();
  document.holds.pins = pins;
  return document;
}

const std::string times = "\xC3\x97";

} // namespace

TEST_CASE("A step tells a new trail by its scale, a path that is not exaggerated and one that is gone by its "
          "range") {
  const Document none = test::boxer();
  CHECK(toldBy(none, withArmTrail()) == "left arm " + times + "2");
  Document path = withArmTrail();
  path.trails[0].exaggerated = false;
  CHECK(toldBy(none, path) == "left arm 0 to 10");
  CHECK(toldBy(withArmTrail(), none) == "left arm 0 to 10");
  CHECK(toldBy(path, withArmTrail()) == "left arm " + times + "2");
  Document named = withArmTrail();
  named.trails[0].name = "Haymaker";
  CHECK(toldBy(none, named) == "Haymaker " + times + "2");
  CHECK(toldBy(named, none) == "Haymaker 0 to 10");
  CHECK(toldBy(withArmTrail(), withArmTrail()).empty());
}

TEST_CASE("A step tells the one setting of a trail that changed as panels show it") {
  using Settings = rig::TrailSettings;
  const auto changed = [](const TrailChange& change) { return ofChange(change); };
  CHECK(changed([](Settings& s) { s.scale = 3.25; }) == "left arm " + times + "3.25");
  CHECK(changed([](Settings& s) { s.scale = 2.126; }) == "left arm " + times + "2.13");
  CHECK(changed([](Settings& s) { s.axes = {true, false, true}; }) == "left arm xz");
  CHECK(changed([](Settings& s) { s.axes = {false, false, false}; }) == "left arm none");
  CHECK(changed([](Settings& s) { s.pivot = rig::Pivot::end; }) == "left arm end");
  CHECK(changed([](Settings& s) { s.turnLimitDegrees = 30.0; }) == "left arm 30 degrees");
  CHECK(changed([](Settings& s) { s.blend = 1.0; }) == "left arm 50 %");
  CHECK(changed([](Settings& s) { s.volume = 0.25; }) == "left arm 25 %");
  CHECK(changed([](Settings& s) { s.turnEnd = true; }) == "left arm on");
  CHECK(changed([](Settings& s) { s.pull = false; }) == "left arm off");
  CHECK(changed([](Settings& s) { s.releaseFrames = 12.0; }) == "left arm 12 frames");
  CHECK(changed([](Settings& s) { s.overshoot = 0.1; }) == "left arm 10 %");
  CHECK(changed([](Settings& s) { s.sight.camera = "side"; }) == "left arm side");
  const auto released = [](Settings& s) { s.releaseFrames = 12.0; };
  CHECK(toldBy(withSettings(withArmTrail(), released), withArmTrail()) == "left arm automatic");
  const auto seen = [](Settings& s) { s.sight.camera = "side"; };
  CHECK(toldBy(withSettings(withArmTrail(), seen), withArmTrail()) == "left arm none");
  // An ease is two numbers, and of several settings none is told.
  CHECK(changed([](Settings& s) { s.easeIn.percent = 0.3; }) == "left arm");
  CHECK(changed([](Settings& s) {
          s.scale = 3.0;
          s.volume = 0.5;
        }) == "left arm");
}

TEST_CASE("A step tells a range that changed at either end, before any setting") {
  using Settings = rig::TrailSettings;
  CHECK(ofChange([](Settings& s) { s.startFrame = 2.0; }) == "left arm 2 to 10");
  CHECK(ofChange([](Settings& s) { s.endFrame = 8.5; }) == "left arm 0 to 8.5");
  CHECK(ofChange([](Settings& s) {
          s.endFrame = 8.254;
          s.scale = 3.0;
        }) == "left arm 0 to 8.25");
}

TEST_CASE("A step tells where the one sphere is that was pulled, pulled on or put back") {
  using Settings = rig::TrailSettings;
  const rig::SphereOffset at4{4.0, Vec3(0.1)};
  const rig::SphereOffset at4Further{4.0, Vec3(0.2)};
  const rig::SphereOffset at7{7.5, Vec3(0.1)};
  const auto with = [](const std::vector<rig::SphereOffset>& spheres) {
    return withSettings(withArmTrail(), [&](Settings& s) { s.spheres = spheres; });
  };
  CHECK(toldBy(with({}), with({at7})) == "left arm at frame 7.5");
  CHECK(toldBy(with({at7}), with({})) == "left arm at frame 7.5");
  CHECK(toldBy(with({at4, at7}), with({at4Further, at7})) == "left arm at frame 4");
  CHECK(toldBy(with({at4, at7}), with({at4})) == "left arm at frame 7.5");
  CHECK(toldBy(with({}), with({at4, at7})) == "left arm");
  CHECK(toldBy(with({at4}), with({at7})) == "left arm");
}

TEST_CASE("Several trails are told once with what they have in common, three by their names and more by how "
          "many there are") {
  using Settings = rig::TrailSettings;
  Document before = test::boxer();
  for (const char* const limb : {"left-arm", "right-arm", "spine"}) {
    before = test::withNewTrail(before, {.limb = limb});
  }
  const auto scaled = [&](const std::vector<double>& scales) {
    Document after = before;
    for (std::size_t i = 0; i < scales.size(); ++i) {
      after = withSettings(
          after, [&](Settings& s) { s.scale = scales[i]; }, i);
    }
    return after;
  };
  CHECK(toldBy(before, scaled({3.0, 3.0})) == "left arm and right arm " + times + "3");
  CHECK(toldBy(before, scaled({3.0, 4.0})) == "left arm and right arm");
  CHECK(toldBy(before, scaled({3.0, 3.0, 3.0})) == "left arm, right arm and spine " + times + "3");
  Document four = test::withNewTrail(before, {.limb = "left-arm", .startFrame = 12.0, .endFrame = 18.0});
  const Document fourScaled = [&] {
    Document after = four;
    for (rig::Trail& trail : after.trails) {
      trail.settings.scale = 3.0;
    }
    return after;
  }();
  CHECK(toldBy(four, fourScaled) == "left arm, right arm and spine " + times + "3"); // one limb twice
  four.trails.back().name = "Second";
  Document namedScaled = fourScaled;
  namedScaled.trails.back().name = "Second";
  CHECK(toldBy(four, namedScaled) == "4 limbs " + times + "3");
}

TEST_CASE("What the label names already is not told again") {
  using Settings = rig::TrailSettings;
  const Document before = withArmTrail();
  const Document after = withSettings(before, [](Settings& s) { s.scale = 3.0; });
  CHECK(stepText("Pull the left arm", before, after) == "Pull the left arm \xE2\x80\x93 " + times + "3");
  CHECK(stepText("Scale all limbs", before, after) == "Scale all limbs \xE2\x80\x93 " + times + "3");
  CHECK(stepText("Scale climbs", before, after) == "Scale climbs \xE2\x80\x93 left arm " + times + "3");
  const Document eased = withSettings(before, [](Settings& s) { s.easeIn.percent = 0.3; });
  CHECK(stepText("Ease the left arm", before, eased) == "Ease the left arm");
}

TEST_CASE("A step tells weight by its limb and the one setting that changed") {
  const Document none = test::boxer();
  const Document plain = withWeight(none, [](WeightSettings&) {});
  CHECK(toldBy(none, plain) == "right arm");
  CHECK(toldBy(plain, none) == "right arm");
  CHECK(toldBy(plain, withWeight(none, [](WeightSettings& s) { s.amount = 0.5; })) == "right arm 50 %");
  CHECK(toldBy(plain, withWeight(none, [](WeightSettings& s) { s.damping = 2.5; })) == "right arm 2.5");
  CHECK(toldBy(plain, withWeight(none, [](WeightSettings& s) { s.youngModulus = 20000.0; })) ==
        "right arm 20 kPa");
  CHECK(toldBy(plain, withWeight(none, [](WeightSettings& s) { s.density = 900.0; })) ==
        "right arm 900 kg/m^3");
  CHECK(toldBy(plain, withWeight(none, [](WeightSettings& s) {
                 s.density = 900.0;
                 s.damping = 2.5;
               })) == "right arm");
  Document off = plain;
  off.weights[0].on = false;
  CHECK(toldBy(plain, off) == "right arm");
  CHECK(toldBy(plain, plain).empty());
}

TEST_CASE("A step tells the one key of a controller that is new, another or gone") {
  const Document none = test::boxer();
  const Document one = withKeys(none, "left-hand", {{8.0, 0.1}});
  const Document two = withKeys(none, "left-hand", {{8.0, 0.1}, {12.5, 0.1}});
  CHECK(toldBy(none, one) == "left hand at frame 8");
  CHECK(toldBy(one, none) == "left hand at frame 8");
  CHECK(toldBy(one, two) == "left hand at frame 12.5");
  CHECK(toldBy(two, one) == "left hand at frame 12.5");
  CHECK(toldBy(one, withKeys(none, "left-hand", {{8.0, 0.3}})) == "left hand at frame 8");
  CHECK(toldBy(none, two) == "left hand");
  CHECK(toldBy(one, withKeys(none, "left-hand", {{9.0, 0.1}})) == "left hand");
  Document range = one;
  range.adjustments[0].rangeFrames = Vec2(4.0, 12.0);
  CHECK(toldBy(one, range) == "left hand");
  const Document both = withKeys(one, "hips", {{8.0, 0.2}});
  CHECK(toldBy(none, both) == "hips and left hand at frame 8");
  CHECK(toldBy(one, both) == "hips at frame 8");
  CHECK(toldBy(none, withKeys(one, "hips", {{9.0, 0.2}})) == "hips and left hand");
  Document many = both;
  for (const char* const other : {"right-hand", "body"}) {
    many = withKeys(many, other, {{8.0, 0.2}});
  }
  CHECK(toldBy(none, many) == "4 controllers at frame 8");
  CHECK(stepText("Key 4 controllers", none, many) == "Key 4 controllers \xE2\x80\x93 at frame 8");
}

TEST_CASE("A step that changes the rate of a clip tells the new one alone") {
  const Document before = withArmTrail();
  Document after = before;
  setFramesPerSecond(after, 24.0);
  CHECK(toldBy(before, after) == "24 fps");
  setFramesPerSecond(after, 23.976);
  CHECK(toldBy(before, after) == "23.98 fps");
  CHECK(toldBy(after, before) == "30 fps");
}

TEST_CASE("A step tells what it came to hold, and where and in whose place") {
  const Document none = test::boxer();
  CHECK(toldBy(none, withPins({pinOf("left-arm", 2.0, 6.25)})) == "left arm 2 to 6.25");
  CHECK(toldBy(withPins({pinOf("left-arm", 2.0, 6.0)}), none) == "left arm 2 to 6");
  const std::vector<rig::Pin> three{pinOf("left-arm", 0.0, 1.0), pinOf("left-arm", 2.0, 3.0),
                                    pinOf("left-arm", 4.0, 5.0)};
  CHECK(toldBy(none, withPins(three)) == "left arm 0 to 1, 2 to 3 and 4 to 5");
  std::vector<rig::Pin> more = three;
  more.push_back(pinOf("left-arm", 6.0, 7.0));
  CHECK(toldBy(none, withPins(more)) == "left arm 0 to 1, 2 to 3 and 2 more");
  CHECK(toldBy(withPins(three), withPins(more)) == "left arm 6 to 7");
  CHECK(toldBy(none, withPins({pinOf("left-arm", 0.0, 1.0), pinOf("right-arm", 2.0, 3.0)})) ==
        "left arm 0 to 1, right arm 2 to 3");
  CHECK(toldBy(withPins({pinOf("right-arm", 2.0, 3.0)}),
               withPins({pinOf("left-arm", 0.0, 1.0), pinOf("right-arm", 1.0, 3.0)})) ==
        "left arm 0 to 1, right arm 1 to 3 in the place of 2 to 3");
  Document gripped = none;
  rig::Grip grip;
  grip.leader = "left-arm";
  grip.follower = "right-arm";
  grip.time.rangeFrames = Vec2(3.0, 9.0);
  gripped.holds.grips = {grip};
  CHECK(toldBy(none, gripped) == "right arm with left arm 3 to 9");
  CHECK(toldBy(gripped, none) == "right arm with left arm 3 to 9");
  Document propped = none;
  rig::Prop prop;
  prop.node = "Stick";
  prop.hands = {{"left-arm", {}}, {"right-arm", {}}};
  propped.holds.props = {prop};
  CHECK(toldBy(none, propped) == "Stick in left arm and right arm over the whole clip");
  propped.holds.props[0].time.emplace();
  propped.holds.props[0].time->rangeFrames = Vec2(1.0, 4.0);
  CHECK(toldBy(none, propped) == "Stick in left arm and right arm 1 to 4");
  CHECK(toldBy(propped, none) == "Stick in left arm and right arm 1 to 4");
  Document bound = propped; // otherwise, in the same frames
  bound.holds.props[0].boundFrame = 2.0;
  CHECK(toldBy(propped, bound) == "Stick in left arm and right arm 1 to 4");
}

TEST_CASE("A step of a sequence tells the one setting that changed, of the fit before that of the clip") {
  const SequenceDocument before;
  const auto told = [&](const std::function<void(SequenceDocument&)>& change) {
    SequenceDocument after = before;
    change(after);
    return stepText("Change", before, after);
  };
  CHECK(told([](SequenceDocument&) {}) == "Change");
  CHECK(told([](SequenceDocument& d) { d.settings.bones = 47; }) == "Change \xE2\x80\x93 47");
  CHECK(told([](SequenceDocument& d) { d.settings.fit.largestScale = 3.5; }) == "Change \xE2\x80\x93 3.5");
  CHECK(told([](SequenceDocument& d) { d.encoding.quantise = false; }) == "Change \xE2\x80\x93 off");
  CHECK(told([](SequenceDocument& d) { d.encoding.keyTolerancePercent = 0.25; }) ==
        "Change \xE2\x80\x93 0.25 %");
  CHECK(told([](SequenceDocument& d) {
          d.settings.bones = 47;
          d.encoding.quantise = false;
        }) == "Change \xE2\x80\x93 47");
}

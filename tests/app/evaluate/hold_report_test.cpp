#include "app/evaluate/hold_report.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "app/evaluate/evaluate.h"
#include "tests/support/app/things_of_clip.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double boxerArm = 0.6;
const Vec3 leftShoulder(0.2, 1.5, 0.0);
const Vec3 rightShoulder(-0.2, 1.5, 0.0);

/// A pin without stretch so far from the shoulder, above it.
rig::Pin pinAway(const std::string& limb, double distance, int clip = 0) {
  rig::Pin pin;
  pin.limb = limb;
  pin.clip = clip;
  pin.time = {{4.0, 9.0}, {2.0, 3.0}};
  pin.place =
      rig::HeldPlace{(limb == "left-arm" ? leftShoulder : rightShoulder) + Vec3(0.0, distance, 0.0), {}};
  pin.turns = false;
  pin.stretch = 0.0;
  return pin;
}

std::vector<HoldReport> reportsOf(const Document& document, int clip = 0) {
  return holdReports(document, prepareMotion(document, clip));
}

std::vector<double> halvesFrom(double first, double last) {
  std::vector<double> frames;
  for (double frame = first; frame <= last; frame += 0.5) {
    frames.push_back(frame);
  }
  return frames;
}

rig::MotionState motionOf(double endSeconds, double framesPerSecond) {
  rig::MotionState motion;
  motion.endSeconds = endSeconds;
  motion.framesPerSecond = framesPerSecond;
  return motion;
}

} // namespace

TEST_CASE("Holds are looked at on the frames and half frames of the whole clip, up to twenty thousand") {
  CHECK(halfFramesOf(motionOf(2.0, 10.0)) == halvesFrom(0.0, 20.0));
  CHECK(halfFramesOf(motionOf(1.04, 10.0)) == halvesFrom(0.0, 10.0));
  CHECK(halfFramesOf(motionOf(0.0, 10.0)) == std::vector{0.0});
  CHECK(halfFramesOf(motionOf(1e9, 30.0)).size() == 40001);
}

TEST_CASE("A pin out of reach falls short by what is missing, wherever it holds fully") {
  Document document = test::twoPunches();
  const double missing = GENERATE(0.05, 0.3);
  document.holds.pins = {pinAway("left-arm", boxerArm + missing)};
  const std::vector<HoldReport> reports = reportsOf(document);
  REQUIRE(reports.size() == 1);
  CHECK(reports[0].kind == rig::HoldKind::pin);
  CHECK(reports[0].index == 0);
  CHECK(reports[0].limb == "left-arm");
  CHECK(reports[0].farthest == Approx(missing).margin(1e-4));
  CHECK(reports[0].framesFallShort == halvesFrom(4.0, 9.0)); // Not where it comes and goes.
}

TEST_CASE("A thousandth of the height is no falling short, and what is reached is none") {
  Document document = test::twoPunches();
  document.body.height = GENERATE(1.8, 40.0);
  const double seen = 1e-3 * document.body.height;
  const auto framesAt = [&](double distance) {
    document.holds.pins = {pinAway("left-arm", distance)};
    const std::vector<HoldReport> reports = reportsOf(document);
    REQUIRE(reports.size() == 1);
    return reports[0].framesFallShort.size();
  };
  CHECK(framesAt(0.5 * boxerArm) == 0);
  CHECK(framesAt(boxerArm + 0.9 * seen) == 0);
  CHECK(framesAt(boxerArm + 1.1 * seen) == 11);
}

TEST_CASE("Each hold is told by its place in its list and by its limb, those of other clips left out") {
  Document document = test::twoPunches();
  document.holds.pins = {pinAway("left-arm", boxerArm + 0.4, 1), pinAway("right-arm", boxerArm + 0.1),
                         pinAway("left-arm", boxerArm + 0.2)};
  const std::vector<HoldReport> first = reportsOf(document, 0);
  REQUIRE(first.size() == 2);
  for (const HoldReport& report : first) {
    const bool isRight = report.limb == "right-arm";
    CHECK(report.index == (isRight ? 0U : 1U));
    CHECK(report.farthest == Approx(isRight ? 0.1 : 0.2).margin(1e-4));
  }
  CHECK(first[0].limb != first[1].limb);
  const std::vector<HoldReport> second = reportsOf(document, 1);
  REQUIRE(second.size() == 1);
  CHECK(second[0].farthest == Approx(0.4).margin(1e-4));
  document.holds.pins.clear();
  CHECK(reportsOf(document, 0).empty());
}

TEST_CASE("A grip is told beside a pin, and a prop in two hands for each of them") {
  Document document = test::twoPunches();
  rig::Grip grip;
  grip.follower = "right-arm";
  grip.leader = "left-arm";
  grip.time = {{12.0, 14.0}, {0.0, 0.0}};
  document.holds.grips = {grip};
  document.holds.pins = {pinAway("left-arm", boxerArm + 0.1)};
  std::vector<HoldReport> reports = reportsOf(document);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0].kind == rig::HoldKind::pin);
  CHECK(reports[1].kind == rig::HoldKind::grip);
  CHECK(reports[1].limb == "right-arm");
  CHECK(reports[1].framesFallShort.empty());

  document.holds = {};
  rig::Prop prop;
  prop.node = "Stick";
  prop.hands = {{"left-arm", {{.frame = 0.0, .value = 1.0}}}, {"right-arm", {{.frame = 0.0, .value = 1.0}}}};
  document.holds.props = {prop};
  reports = reportsOf(document);
  REQUIRE(reports.size() == 2);
  for (const HoldReport& report : reports) {
    CHECK(report.kind == rig::HoldKind::prop);
    CHECK(report.index == 0);
  }
  CHECK(reports[0].limb != reports[1].limb);
}

TEST_CASE(
    "A hold that another one of its limb overrides is told with the frames and with what decides there") {
  Document document = test::twoPunches();
  rig::Pin pin = pinAway("left-arm", 0.5 * boxerArm);
  pin.stretch = 1.0;
  document.holds.pins = {pin};
  rig::Grip grip;
  grip.follower = "left-arm";
  grip.leader = "right-arm";
  grip.time = {{6.0, 8.0}, {0.0, 0.0}};
  document.holds.grips = {grip};
  std::vector<HoldReport> reports = reportsOf(document);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0].kind == rig::HoldKind::pin);
  CHECK(reports[0].framesOverridden == halvesFrom(6.0, 8.0));
  CHECK(reports[0].overriddenBy == rig::HoldKind::grip);
  CHECK(reports[0].farthestOverridden > 0.1);
  CHECK(reports[0].framesFallShort.empty());
  CHECK(reports[0].farthest < 1e-6);
  CHECK_THAT(overrideWarning(reports[0]), Catch::StartsWith("the pin of left-arm is left by up to ") &&
                                              Catch::EndsWith(" at frames 6 to 8: the grip decides there"));
  CHECK(holdWarning(reports[0]).empty());
  CHECK(reports[1].framesOverridden.empty());
  CHECK(overrideWarning(reports[1]).empty());

  // Half of a hold takes half of the other one from its place, and is told with that.
  document.holds.grips.clear();
  rig::Prop prop;
  prop.node = "Stick";
  prop.hands = {{"right-arm", {{.frame = 0.0, .value = 1.0}}}, {"left-arm", {{.frame = 0.0, .value = 0.5}}}};
  document.holds.props = {prop};
  reports = reportsOf(document);
  REQUIRE(reports.size() == 3);
  const auto ofPin = std::ranges::find(reports, rig::HoldKind::pin, &HoldReport::kind);
  REQUIRE(ofPin != reports.end());
  CHECK(ofPin->framesOverridden == halvesFrom(4.0, 9.0));
  CHECK(ofPin->overriddenBy == rig::HoldKind::prop);
  CHECK(ofPin->strength == 1.0);
  const auto half = std::ranges::find(reports, 0.5, &HoldReport::strength);
  REQUIRE(half != reports.end());
  CHECK(half->limb == "left-arm");
  CHECK(half->framesFallShort.empty());
}

TEST_CASE("A pin whose hand holds a prop by itself is not overridden by that") {
  Document document = test::twoPunches();
  rig::Pin pin = pinAway("left-arm", 0.5 * boxerArm);
  pin.stretch = 1.0;
  document.holds.pins = {pin};
  rig::Prop prop;
  prop.node = "Stick";
  prop.hands = {{"left-arm", {{.frame = 0.0, .value = 1.0}}}};
  document.holds.props = {prop};
  for (const HoldReport& report : reportsOf(document)) {
    CHECK(report.framesOverridden.empty());
    CHECK(report.framesFallShort.empty());
  }
}

TEST_CASE("A hold that falls short is told with its limb, its frames and how far, another not") {
  HoldReport report{rig::HoldKind::pin, 0, "left-arm", 0.12345, {5.0, 5.5, 9.5}};
  CHECK(holdWarning(report) == "the pin of left-arm falls short at frames 5 to 9.5 by up to 0.1235: let it "
                               "stretch, or move what it holds to");
  report.kind = rig::HoldKind::grip;
  CHECK_THAT(holdWarning(report), Catch::StartsWith("the grip of left-arm falls"));
  report.kind = rig::HoldKind::prop;
  CHECK_THAT(holdWarning(report), Catch::StartsWith("the prop of left-arm falls"));
  report.framesFallShort = {};
  CHECK(holdWarning(report).empty());
}

TEST_CASE("A hold that another one of its own kind overrides is told to be left for another one") {
  HoldReport report{rig::HoldKind::prop, 0, "left-arm"};
  report.farthestOverridden = 0.25;
  report.framesOverridden = {3.0, 3.5, 4.0};
  report.overriddenBy = rig::HoldKind::prop;
  CHECK(overrideWarning(report) ==
        "the prop of left-arm is left by up to 0.25 at frames 3 to 4: another prop decides there");
  report.overriddenBy = rig::HoldKind::grip;
  CHECK_THAT(overrideWarning(report), Catch::EndsWith(": the grip decides there"));
}

#include "app/evaluate/pops.h"

#include <algorithm>
#include <cstdint>
#include <memory>

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/session.h"
#include "core/base/index.h"
#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double legLength = 0.9;

// A biped that stands for two seconds on straight legs.
Document standingBiped() {
  test::SyntheticBiped body = test::makeNamedBody("Mixamo");
  for (const std::string side : {".l", ".r"}) {
    const Vec3 hip = test::jointOf(body, "thigh" + side).position;
    test::jointOf(body, "shin" + side).position = hip - Vec3(0.0, 0.5 * legLength, 0.0);
    test::jointOf(body, "foot" + side).position = hip - Vec3(0.0, legLength, 0.0);
  }
  test::MovingBiped moving = test::still(body);
  Document document;
  document.scene = std::make_shared<const Scene>(moving.scene);
  document.body = moving.body;
  Clip clip = moving.clip;
  clip.framesPerSecond = 24.0;
  clip.endSeconds = 2.0;
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  return document;
}

rig::OffsetKey lowered(double frame, double share) {
  rig::OffsetKey key;
  key.frame = frame;
  key.move = Vec3(0.0, -share * legLength, 0.0);
  return key;
}

// The hips sink and come up to where they were within 12 frames.
rig::Adjustment risingHips(double share) {
  return {"hips", 0, std::nullopt, {lowered(0, 0.0), lowered(12, share), lowered(24, 0.0)}};
}

rig::Adjustment softened(const std::string& attribute, double value) {
  rig::OffsetKey key;
  key.value = value;
  return {attribute, 0, std::nullopt, {key}};
}

Document posedBy(const std::vector<rig::Adjustment>& adjustments) {
  const Result<Document> posed = placeAdjustments(standingBiped(), adjustments);
  REQUIRE(posed);
  return *posed;
}

std::vector<LimbPop> popsOf(const std::vector<rig::Adjustment>& adjustments, const FrameSpan& frames = {}) {
  const Document posed = posedBy(adjustments);
  return limbPops(posed, prepareMotion(posed, 0), frames);
}

} // namespace

TEST_CASE("Knees that come out of straight legs pop, each with its frame and a way out") {
  const std::vector<LimbPop> pops = popsOf({risingHips(0.12)});
  REQUIRE(pops.size() == 2);
  CHECK(pops[0].limb == "left-leg");
  CHECK(pops[1].limb == "right-leg");
  for (const LimbPop& pop : pops) {
    CHECK(pop.times > 4.0);
    CHECK((pop.frame <= 2.0 || (pop.frame >= 22.0 && pop.frame <= 26.0)));
    const std::string limb = &pop == &pops[0] ? "left leg" : "right leg";
    CHECK(popWarning(pop).starts_with("the " + limb + " pops at frame "));
    CHECK(popWarning(pop).find("softness") != std::string::npos);
  }
}

TEST_CASE("Softness takes the pop of its own leg away, and that of the other one stays") {
  const std::vector<LimbPop> hard = popsOf({risingHips(0.12)});
  const std::vector<LimbPop> soft = popsOf({risingHips(0.12), softened("left-leg.softness", 0.3)});
  REQUIRE(hard.size() == 2);
  REQUIRE(!soft.empty());
  CHECK(soft.back().limb == "right-leg");
  CHECK(soft.back().times == Approx(hard.back().times));
  for (const LimbPop& pop : soft) {
    CHECK((pop.limb == "right-leg" || pop.times < 0.6 * hard.front().times));
  }
}

TEST_CASE("A knee that bends by less than one sees, and one that nothing moves, are no pop") {
  CHECK(popsOf({}).empty());
  CHECK(popsOf({risingHips(0.0002)}).empty());
}

TEST_CASE("Only the frames asked for are looked at, and a pop is told by its frame of the clip") {
  CHECK(popsOf({risingHips(0.12)}, {5, 19}).empty());
  const std::vector<LimbPop> late = popsOf({risingHips(0.12)}, {15, 40});
  REQUIRE(late.size() == 2);
  CHECK(late[0].frame >= 22.0);
  CHECK(late[0].frame <= 26.0);
}

TEST_CASE("A session tells the pops around the playhead, and during a drag those from before it") {
  Session session(standingBiped());
  CHECK(session.pops().empty());
  session.edit(posedBy({risingHips(0.12)}), "Lower");
  CHECK(session.pops().size() == 2);
  session.view().frame = 400.0;
  CHECK(session.pops().empty());
  session.view().frame = 0.0;
  REQUIRE(session.pops().size() == 2);
  session.begin("Raise");
  session.preview(standingBiped());
  CHECK(session.pops().size() == 2);
  session.cancel();
  CHECK(session.pops().size() == 2);
}

TEST_CASE("A leg that is folded until its foot passes its hip flips, and is told of with its frame") {
  const auto turnedBy = [](double share) {
    const Document posed =
        posedBy({{"hips",
                  0,
                  std::nullopt,
                  {lowered(0, 0.6), lowered(10, 0.6), lowered(11, share), lowered(40, share)}},
                 softened("left-leg.softness", 0.1),
                 softened("right-leg.softness", 0.1)});
    return limbPops(posed, prepareMotion(posed, 0), {});
  };
  const std::vector<LimbPop> over = turnedBy(1.3);
  REQUIRE(over.size() == 2);
  for (const LimbPop& pop : over) {
    CHECK(pop.frame == 11.0);
    CHECK(pop.times == 0.0);
    CHECK(pop.turnDegrees > 150.0);
    CHECK(pop.sourceDegrees == Approx(0.0).margin(0.1));
  }
  CHECK(popWarning(over[1]).starts_with("the right leg flips at frame 11: it turns by 174 degrees within a "
                                        "frame, 0 in the clip; "));
  CHECK(turnedBy(0.8).empty()); // folded more, and not past its hip
}

TEST_CASE("Every frame in which a leg flips is told in one line, beside its pop") {
  const Document posed = posedBy({{"hips",
                                   0,
                                   std::nullopt,
                                   {lowered(0, 0.0), lowered(12, 0.12), lowered(24, 0.0), lowered(34, 0.6),
                                    lowered(35, 1.3), lowered(44, 1.3), lowered(45, 0.6)}}});
  std::vector<LimbPop> told = limbPops(posed, prepareMotion(posed, 0), {});
  std::erase_if(told, [](const LimbPop& pop) { return pop.limb != "left-leg" || !pop.freeFrames.empty(); });
  REQUIRE(told.size() == 2);
  CHECK(told[0].times > 4.0);
  CHECK(told[0].flipFrames.empty());
  CHECK(told[1].times == 0.0);
  CHECK(told[1].flipFrames == std::vector<std::int64_t>{35, 45});
  CHECK_THAT(popWarning(told[1]), Catch::StartsWith("the left leg flips at frames 35, 45: it turns by ") &&
                                      Catch::Contains(fmt::format("within frame {:g}", told[1].frame)));
}

namespace {

rig::OffsetKey movedTo(double frame, const Vec3& move) {
  rig::OffsetKey key;
  key.frame = frame;
  key.move = move;
  return key;
}

double thighTurn(const Document& posed, double frame) {
  const NodeIndex thigh = findLimb(posed, "left-leg")->joints.front();
  const rig::MotionState motion = prepareMotion(posed, 0);
  const auto turnAt = [&](double at) {
    return rotationOf(evaluate(posed, motion, at / 24.0).worlds[stretch::at(thigh)]);
  };
  return angleBetween(turnAt(frame - 1.0), turnAt(frame)) * 180.0 / pi;
}

const rig::Adjustment sunkHips{"hips", 0, std::nullopt, {lowered(0, 0.1)}};

} // namespace

TEST_CASE("A knee that its pole leads round is meant to turn, and not told of") {
  const rig::Adjustment pole{
      "left-knee", 0, std::nullopt, {movedTo(0, Vec3(0.0)), movedTo(12, Vec3(1.5, 0.0, -0.45))}};
  const Document posed = posedBy({sunkHips, pole});
  REQUIRE(thighTurn(posed, 6.0) > 5.5);
  const std::vector<LimbPop> told = limbPops(posed, prepareMotion(posed, 0), {});
  CHECK(std::ranges::all_of(told, [](const LimbPop& pop) { return pop.freeFrames.empty(); }));
}

TEST_CASE("A knee that goes round as its foot passes its pole is told of with each of these frames") {
  const rig::Adjustment pole{"left-knee", 0, std::nullopt, {movedTo(0, Vec3(0.03, 0.0, -0.4))}};
  const rig::Adjustment foot{
      "left-foot", 0, std::nullopt, {movedTo(0, Vec3(0.0)), movedTo(36, Vec3(0.0, 0.0, 0.2))}};
  const Document posed = posedBy({sunkHips, pole, foot});
  std::vector<std::int64_t> wanted;
  double most = 0.0;
  for (std::int64_t frame = 1; frame <= 47; ++frame) {
    const double turn = thighTurn(posed, static_cast<double>(frame));
    most = std::max(most, turn);
    if (turn > 5.0) {
      wanted.push_back(frame);
    }
  }
  const std::vector<LimbPop> told = limbPops(posed, prepareMotion(posed, 0), {});
  REQUIRE(told.size() == 1);
  CHECK(told[0].limb == "left-leg");
  CHECK(wanted.size() > 3);
  CHECK(told[0].freeFrames == wanted);
  CHECK(told[0].turnDegrees == Approx(most).epsilon(0.01)); // of the shin, which turns with it
  CHECK(told[0].sourceDegrees == Approx(0.0).margin(0.1));
  CHECK(popWarning(told[0]).starts_with(
      fmt::format("the left leg turns at frames {} to {} though its ends do not make it: by {:.0f} degrees "
                  "within frame {:g}, 0 in the clip; ",
                  wanted.front(), wanted.back(), most, told[0].frame)));
  const std::vector<LimbPop> late = limbPops(posed, prepareMotion(posed, 0), {wanted[1], 47});
  REQUIRE(late.size() == 1);
  CHECK(late[0].freeFrames == std::vector<std::int64_t>(wanted.begin() + 2, wanted.end()));
}

TEST_CASE("A knee that goes round is told of but where a trail of its own leg acts") {
  const rig::Adjustment pole{"left-knee", 0, std::nullopt, {movedTo(0, Vec3(0.03, 0.0, -0.4))}};
  const rig::Adjustment foot{
      "left-foot", 0, std::nullopt, {movedTo(0, Vec3(0.0)), movedTo(36, Vec3(0.0, 0.0, 0.2))}};
  Document posed = posedBy({sunkHips, pole, foot});
  const std::vector<LimbPop> before = limbPops(posed, prepareMotion(posed, 0), {});
  REQUIRE(before.size() == 1);
  const std::vector<std::int64_t> all = before[0].freeFrames;
  REQUIRE(all.size() > 3);
  const auto framesWithTrailOf = [&](const std::string& limb) {
    rig::Trail trail;
    trail.id = 1;
    trail.limb = limb;
    trail.settings.startFrame = static_cast<double>(all.front()) - 3.0;
    trail.settings.endFrame = static_cast<double>(all.back()) + 3.0;
    trail.exaggerated = true;
    trail.connected = true;
    Document moving = posed;
    moving.trails.push_back(trail);
    std::vector<std::int64_t> told;
    for (const LimbPop& pop : limbPops(moving, prepareMotion(moving, 0), {})) {
      told.insert(told.end(), pop.freeFrames.begin(), pop.freeFrames.end());
    }
    return told;
  };
  CHECK(framesWithTrailOf("left-leg").empty());
  CHECK(framesWithTrailOf("right-leg") == all);
}

TEST_CASE("A trail of a leg that a hold has all of says nothing about what the hold turns") {
  const rig::Adjustment pole{"left-knee", 0, std::nullopt, {movedTo(0, Vec3(0.03, 0.0, -0.4))}};
  const rig::Adjustment hips{
      "hips", 0, std::nullopt, {movedTo(0, Vec3(0.0, -0.09, 0.0)), movedTo(36, Vec3(0.0, -0.09, -0.2))}};
  Document posed = posedBy({pole, hips});
  rig::Pin pin;
  pin.limb = "left-leg";
  pin.time = {{0.0, 48.0}, {0.0, 0.0}};
  const auto framesToldIn = [](const Document& document) {
    std::vector<std::int64_t> told;
    for (const LimbPop& pop : limbPops(document, prepareMotion(document, 0), {})) {
      if (pop.limb == "left-leg") {
        told.insert(told.end(), pop.freeFrames.begin(), pop.freeFrames.end());
      }
    }
    return told;
  };
  const std::vector<std::int64_t> all = framesToldIn(posed);
  REQUIRE(all.size() > 3);
  rig::Trail trail;
  trail.id = 1;
  trail.limb = "left-leg";
  trail.settings.startFrame = 0.0;
  trail.settings.endFrame = 40.0;
  trail.exaggerated = true;
  trail.connected = true;
  posed.trails.push_back(trail);
  CHECK(framesToldIn(posed).empty());
  posed.holds.pins = {pin};
  CHECK(framesToldIn(posed) == all);
}

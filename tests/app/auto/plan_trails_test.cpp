// What a plan gives each moment of a clip, on a boxer whose clip is long and of which all that a plan asks is
// told.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/auto/planned_trail.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double planEnd = 90.0;

/// The left arm strikes from frame 0 to 10 and is back at 20, and strikes again from 40 to 50.
Document striking() {
  const Document start = test::boxer();
  Track left = test::turnsOf(start, "left-arm");
  for (const auto& [frame, angle] :
       {std::pair(0, 0.0), {10, 1.4}, {20, 0.0}, {40, 0.0}, {50, 1.4}, {60, 0.0}, {90, 0.0}}) {
    test::addKey(left, frame, glm::angleAxis(angle, Vec3(0.0, -1.0, 0.0)));
  }
  Document document = test::withTracks(start, {left});
  document.body.size = 1.8;
  return document;
}

ClipGround plannedGround(const Document& document) {
  ClipGround ground{document, 0};
  ground.framesPerSecond = 30.0;
  ground.lastFrame = planEnd;
  ground.turnFrames = planEnd;
  ground.limbs = allLimbs(document);
  for (double frame = 0.0; frame <= planEnd; frame += 1.0) {
    ground.places.push_back(placesOf(ground.limbs, evaluateOriginal(document, 0, frame / 30.0)));
  }
  return ground;
}

/// Limbs twice as long, ways back of a fifth of the range; no spine goes along.
AutoSettings twiceAsLong() {
  AutoSettings settings;
  for (rig::ScaleRange* range :
       {&settings.style.arm, &settings.style.leg, &settings.style.torso, &settings.style.other}) {
    *range = {1.0, 2.0, 5.0};
  }
  settings.style.release = 0.2;
  return settings;
}

rig::Moment stroke(const std::string& limb, double startFrame, double endFrame, double strength) {
  return {limb, rig::MomentKind::stroke, startFrame, endFrame, endFrame, strength};
}

AutoPlan planFor(const ClipGround& ground, const std::vector<rig::Moment>& moments,
                 const AutoSettings& settings = twiceAsLong()) {
  return planTrails(ground, moments, settings, {});
}

/// The share of the style's exaggeration that a moment gets; 0 where it gets no trail.
double shareOf(const AutoPlan& plan, std::size_t moment) {
  for (const PlannedTrail& trail : plan.trails) {
    if (trail.moment == moment && !trail.follows) {
      return trail.trail.settings.scale - 1.0;
    }
  }
  return 0.0;
}

std::string whyNot(const ClipGround& ground, const rig::Moment& moment) {
  return planFor(ground, {moment}).leftOut[0];
}

const rig::TrailSettings& plannedSettings(const AutoPlan& plan, std::size_t place = 0) {
  REQUIRE(plan.trails.size() > place);
  return plan.trails[place].trail.settings;
}

constexpr const char* noWayBack = "there is no room for the way back";
constexpr const char* isWeak = "it is weak beside the clip's strongest";

} // namespace

TEST_CASE(
    "A moment gets all of a style from six reaches a second on, the strongest of a calm clip from three",
    "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  for (const auto& [strength, share] :
       {std::pair(12.0, 1.0), {5.9, 1.0}, {3.0, 1.0}, {2.9, 2.9 / 3.0}, {1.3, 1.3 / 3.0}, {1.0, 1.0 / 3.0}}) {
    CAPTURE(strength);
    CHECK(shareOf(planFor(ground, {stroke("left-arm", 0, 10, strength)}), 0) == Approx(share));
  }
  AutoSettings half = twiceAsLong();
  half.strength = 0.5;
  CHECK(shareOf(planFor(ground, {stroke("left-arm", 0, 10, 1.5)}, half), 0) == Approx(0.25));
  // Of a spine, which is as long as the body, from one on, beside a stronger limb from two.
  CHECK(shareOf(planFor(ground, {stroke("spine", 0, 10, 1.0)}), 0) == Approx(1.0));
  const auto beside = [&](double strength) {
    return shareOf(planFor(ground, {stroke("left-arm", 20, 30, 2.0), stroke("spine", 0, 10, strength)}), 1);
  };
  CHECK(beside(2.0) == Approx(1.0));
  CHECK(beside(0.9) == Approx(2.7 / 3.0));
  // So is what there is beside it in a calm clip.
  const auto second = [&](double strongest) {
    return shareOf(planFor(ground, {stroke("left-arm", 0, 10, strongest), stroke("left-arm", 40, 50, 3.0)}),
                   1);
  };
  CHECK(second(4.0) == Approx(0.75));
  CHECK(second(5.0) == Approx(0.6));
  CHECK(second(9.0) == Approx(0.5 * 3.0 / 5.4));
  // A fifth of a style at least.
  CHECK(shareOf(planFor(ground, {stroke("left-arm", 0, 10, 6.0), stroke("left-arm", 40, 50, 1.0)}), 1) ==
        Approx(0.2 / 3.6));
  CHECK(whyNot(ground, stroke("left-arm", 0, 10, 0.99)) == "it is too weak to be an action");
}

TEST_CASE("A limb that is short for its body is exaggerated as much more, up to half", "[plan]") {
  const auto [length, more] =
      GENERATE(table<double, double>({{0.6, 1.0}, {0.45, 1.0}, {0.4, 1.125}, {0.3, 1.5}, {0.1, 1.5}}));
  Document document = striking();
  document.body.limbs[0].restLength = length; // A quarter of the body is 0.45.
  const ClipGround ground = plannedGround(document);
  CHECK(shareOf(planFor(ground, {stroke("left-arm", 0, 10, 6.0)}), 0) == Approx(more));
  // Not beside a stronger one: it would draw the eye.
  CHECK(shareOf(planFor(ground, {stroke("right-arm", 0, 10, 9.0), stroke("left-arm", 0, 10, 7.0)}), 1) ==
        Approx(1.0));
}

TEST_CASE("What is weaker than three fifths of the strongest gets less, than 0.15 of it nothing", "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  const auto second = [&](double strength, const AutoSettings& settings = twiceAsLong()) {
    return planFor(ground, {stroke("left-arm", 0, 10, 20.0), stroke("left-arm", 40, 50, strength)}, settings);
  };
  CHECK(shareOf(second(13.0), 1) == Approx(1.0));
  CHECK(shareOf(second(12.0), 1) == Approx(1.0));
  CHECK(shareOf(second(9.0), 1) == Approx(0.75));
  CHECK(shareOf(second(3.1), 1) == Approx(3.1 / 6.0 * 3.1 / 12.0));
  CHECK(second(2.9).leftOut[1] == isWeak);
  CHECK(second(2.9).leftOut[0].empty());
  // Strong ones beside those that are asked for count, as far as they can be done or were.
  AutoSettings settings = twiceAsLong();
  settings.beside = {stroke("left-arm", 70, 80, 40.0)};
  CHECK(second(5.9, settings).leftOut[1] == isWeak);
  CHECK(second(6.1, settings).leftOut[1].empty());
  settings.beside[0].limb = "right-leg"; // The boxer has none.
  CHECK(second(5.9, settings).leftOut[1].empty());
  settings.beside = {stroke("left-arm", 70, 71, 40.0)}; // Too short for a trail.
  CHECK(second(5.9, settings).leftOut[1].empty());
}

TEST_CASE("A trunk that goes along with a strike counts by what is full for it, which is a third of a limb's",
          "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  const auto armBeside = [&](const char* leader, double strength) {
    return shareOf(planFor(ground, {stroke(leader, 40, 50, strength), stroke("left-arm", 0, 10, 4.0)}), 1);
  };
  CHECK(armBeside("right-arm", 5.0) == Approx(0.8));
  CHECK(armBeside("right-arm", 15.0) == Approx(4.0 / 6.0 * 4.0 / (0.6 * 15.0)));
  CHECK(armBeside("spine", 5.0) == Approx(armBeside("right-arm", 15.0)));
  CHECK(armBeside("spine", 1.0) == Approx(1.0)); // it does not lead
  // Beside an arm's strike it is no weaker, and is left out below 0.15 of that.
  const auto spineBeside = [&](double strength) {
    return planFor(ground, {stroke("left-arm", 40, 50, 30.0), stroke("spine", 0, 10, strength)});
  };
  CHECK(shareOf(spineBeside(2.0), 1) == Approx(6.0 / 18.0));
  CHECK(spineBeside(1.6).leftOut[1].empty());
  CHECK(spineBeside(1.4).leftOut[1] == isWeak);
  // Of spines one that leads is as any other.
  CHECK(shareOf(planFor(ground, {stroke("spine", 40, 50, 5.0), stroke("spine", 0, 10, 1.5)}), 1) ==
        Approx(0.75 * 1.5 / 3.0));
  // However long it is, a breath is no action.
  CHECK(whyNot(ground, stroke("spine", 0, 10, 0.9)) == "it is too weak to be an action");
}

TEST_CASE("Each leg's strongest step counts as that of the leg that steps fastest", "[plan]") {
  Document document = striking();
  for (const char* const arm : {"left-arm", "right-arm"}) {
    std::ranges::find(document.body.limbs, std::string(arm), &rig::Limb::id)->kind = rig::LimbKind::leg;
  }
  const ClipGround ground = plannedGround(document);
  const auto step = [](const char* leg, double start, double tip, double strength) {
    rig::Moment moment = stroke(leg, start, tip, strength);
    moment.kind = rig::MomentKind::cycle;
    return moment;
  };
  const auto second = [&](const rig::Moment& other) {
    return shareOf(planFor(ground, {step("right-arm", 0, 10, 10.0), other}), 1);
  };
  CHECK(second(step("left-arm", 40, 50, 2.6)) == Approx(1.0));
  CHECK(second(step("left-arm", 40, 50, 2.4)) == Approx(0.4 * 0.4));   // it hardly goes along
  CHECK(second(step("right-arm", 40, 50, 4.8)) == Approx(0.8 * 0.8));  // the way back of the leg that leads
  CHECK(second(stroke("left-arm", 40, 50, 3.0)) == Approx(0.5 * 0.5)); // no step
  // Steps that are refused count for nothing, those that are switched off as if they were not.
  const std::vector<rig::Moment> steps{step("right-arm", 0, 10, 10.0), step("left-arm", 40, 50, 3.0)};
  CHECK(shareOf(planTrails(ground, steps, twiceAsLong(), {{0, "it cannot be"}}), 1) == Approx(1.0));
  AutoSettings switchedOff = twiceAsLong();
  switchedOff.beside = {steps[0]};
  CHECK(shareOf(planFor(ground, {steps[1]}, switchedOff), 0) == Approx(1.0));
  // What arms do in turn is each its own.
  document.body.limbs[0].kind = rig::LimbKind::arm;
  CHECK(second(step(document.body.limbs[0].id.c_str(), 40, 50, 3.0)) == Approx(0.5 * 0.5));
}

TEST_CASE("What a flying body does counts beside that, and not beside the beats of its wings", "[plan]") {
  Document document = striking();
  const auto right = std::ranges::find(document.body.limbs, std::string("right-arm"), &rig::Limb::id);
  right->kind = rig::LimbKind::wing;
  const ClipGround ground = plannedGround(document);
  const auto actBeside = [&](rig::MomentKind kind, double strength, const char* limb = "left-arm") {
    rig::Moment beat = stroke("right-arm", 60, 70, 15.0);
    beat.kind = kind;
    return shareOf(planFor(ground, {beat, stroke(limb, 0, 10, strength)}), 1);
  };
  CHECK(actBeside(rig::MomentKind::cycle, 3.0) == Approx(1.0));
  CHECK(actBeside(rig::MomentKind::cycle, 2.5) == Approx(2.5 / 3.0));
  CHECK(actBeside(rig::MomentKind::cycle, 2.3) == Approx(2.3 / 6.0 * 2.3 / 9.0)); // only a nod
  CHECK(actBeside(rig::MomentKind::stroke, 3.0) == Approx(0.5 * 3.0 / 9.0));
  CHECK(actBeside(rig::MomentKind::cycle, 3.0, "spine") == Approx(1.0)); // they beat later
  right->kind = rig::LimbKind::arm;
  CHECK(actBeside(rig::MomentKind::cycle, 3.0) == Approx(0.5 * 3.0 / 9.0));
  // Wings hang on a spine, which a stretch would tear while they beat, though it counts more than they do.
  right->kind = rig::LimbKind::wing;
  for (const double strength : {5.0, 5.1}) {
    rig::Moment beat = stroke("right-arm", 0, 10, 15.0);
    beat.kind = rig::MomentKind::cycle;
    CHECK(shareOf(planFor(ground, {beat, stroke("spine", 5, 15, strength)}), 1) == Approx(1.0 / 3.0));
    CHECK(shareOf(planFor(ground, {beat, stroke("spine", 11, 21, strength)}), 1) == Approx(1.0));
  }
  // Nor are weaker acts weak beside the beats, but beside the strongest act.
  rig::Moment beat = stroke("right-arm", 0, 10, 20.0);
  beat.kind = rig::MomentKind::cycle;
  const AutoPlan plan = planFor(ground, {beat, stroke("left-arm", 0, 10, 2.5), stroke("spine", 20, 30, 0.1)});
  CHECK(plan.leftOut[1].empty());
  CHECK(plan.leftOut[2] == isWeak);
}

TEST_CASE("A moment that is refused makes no other one weak, and tells why it is", "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  const std::vector<rig::Moment> moments{stroke("left-arm", 40, 50, 40.0), stroke("left-arm", 0, 10, 5.0)};
  CHECK(planFor(ground, moments).leftOut[1] == isWeak);
  const AutoPlan plan = planTrails(ground, moments, twiceAsLong(), {{0, "it cannot be"}});
  CHECK(plan.leftOut == std::vector<std::string>{"it cannot be", ""});
  CHECK(shareOf(plan, 1) == Approx(1.0));
  // What is refused is told by its place among those that are asked for, not among those beside them.
  AutoSettings settings = twiceAsLong();
  settings.beside = {stroke("left-arm", 70, 80, 60.0)};
  CHECK(planTrails(ground, moments, settings, {{0, "it cannot be"}}).leftOut[1] == isWeak);
}

TEST_CASE("A limb beside a stronger one takes the style's share of it, one that is nearly as strong all",
          "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  AutoSettings settings = twiceAsLong();
  settings.style.spread.limbs = 0.25;
  const auto shareBeside = [&](const rig::Moment& second) {
    return shareOf(planFor(ground, {stroke("left-arm", 0, 10, 20.0), second}, settings), 1);
  };
  CHECK(shareBeside(stroke("right-arm", 5, 15, 15.9)) == Approx(0.25));
  CHECK(shareBeside(stroke("right-arm", 5, 15, 16.1)) == Approx(1.0));
  CHECK(shareBeside(stroke("right-arm", 10, 20, 15.0)) == Approx(1.0)); // One after the other.
  CHECK(shareBeside(stroke("left-arm", 40, 50, 15.0)) == Approx(1.0));
  CHECK(shareBeside(stroke("left-arm", 9, 19, 15.0)) != Approx(0.25)); // Of its own limb none is beside it.
  rig::Moment round = stroke("right-arm", 5, 15, 15.0);
  round.kind = rig::MomentKind::cycle;
  CHECK(shareBeside(round) == Approx(1.0));
}

TEST_CASE("Moments that can have no trail tell why, however strong they are", "[plan]") {
  Document document = striking();
  const ClipGround ground = plannedGround(document);
  rig::Moment landing = stroke("left-arm", 0, 10, 9.0);
  landing.kind = rig::MomentKind::landing;
  const char* const ofBody = "a landing is of the whole body, whose feet stay where they are";
  CHECK(whyNot(ground, landing) == ofBody);
  CHECK(whyNot(ground, stroke(rig::wholeBody, 0, 10, 9.0)) == ofBody);
  CHECK(whyNot(ground, stroke("tail", 0, 10, 9.0)) == "the character has no such limb");
  CHECK(whyNot(ground, stroke("left-arm", 0, 1, 9.0)) == noWayBack);
  CHECK(whyNot(ground, stroke("left-arm", 0, 2, 9.0)).empty());

  rig::Trail own;
  own.id = 1;
  own.limb = "left-arm";
  own.settings.startFrame = 8.0;
  own.settings.endFrame = 30.0;
  document.trails = {own};
  const char* const isThere = "a trail is there already";
  CHECK(whyNot(ground, stroke("left-arm", 0, 10, 9.0)) == isThere);
  CHECK(whyNot(ground, stroke("left-arm", 40, 50, 9.0)).empty());
  CHECK(whyNot(ground, stroke("right-arm", 0, 10, 9.0)).empty());
  // What the user did already counts as an action, so that others are weak beside it.
  const AutoPlan plan = planFor(ground, {stroke("left-arm", 0, 10, 60.0), stroke("left-arm", 40, 50, 8.9)});
  CHECK(plan.leftOut == std::vector<std::string>{isThere, isWeak});
}

TEST_CASE("A stroke that the end of a clip cuts off comes back before it, in a loop it goes on", "[plan]") {
  const Document document = striking();
  ClipGround ground = plannedGround(document);
  const auto endOf = [&](double startFrame, double endFrame) {
    return plannedSettings(planFor(ground, {stroke("left-arm", startFrame, endFrame, 9.0)})).endFrame;
  };
  CHECK(endOf(70, 90) == 84.0); // 0.3 of the range
  CHECK(endOf(70, 89) == 84.0); // of 19: 5.7
  CHECK(endOf(70, 88) == 88.0);
  CHECK(endOf(85, 90) == 88.0); // two frames at least
  CHECK(whyNot(ground, stroke("left-arm", 87, 90, 9.0)) == noWayBack);
  ground.wraps = true;
  CHECK(endOf(70, 90) == 90.0);
}

TEST_CASE("A way back is as long as the style asks, a sixth of a second at least, and ends with the clip",
          "[plan]") {
  const Document document = striking();
  ClipGround ground = plannedGround(document);
  const auto releaseOf = [&](double startFrame, double endFrame, double release = 0.2) {
    AutoSettings settings = twiceAsLong();
    settings.style.release = release;
    const AutoPlan plan = planFor(ground, {stroke("left-arm", startFrame, endFrame, 9.0)}, settings);
    return *plannedSettings(plan).releaseFrames - plannedSettings(plan).lingerFrames;
  };
  CHECK(releaseOf(0, 40) == Approx(8.0));
  CHECK(releaseOf(0, 40, 0.5) == Approx(20.0));
  CHECK(releaseOf(0, 10) == Approx(5.0));
  CHECK(releaseOf(40, 80) == Approx(8.0));
  CHECK(releaseOf(40, 84) == Approx(5.0));
  ground.framesPerSecond = 60.0;
  CHECK(releaseOf(0, 10) == Approx(10.0));
  ground.framesPerSecond = 6.0;
  CHECK(releaseOf(0, 5) == Approx(2.0)); // Never less than two frames.
}

TEST_CASE("A neck or a spine comes back in as long as it went out, where there is room", "[plan]") {
  Document document = striking();
  document.body.limbs[0].kind = GENERATE(rig::LimbKind::neck, rig::LimbKind::spine);
  const AutoPlan plan = planFor(plannedGround(document), {stroke("left-arm", 0, 30, 9.0)});
  CHECK(*plannedSettings(plan).releaseFrames - plannedSettings(plan).lingerFrames == Approx(30.0));
}

TEST_CASE("A tail or a feeler settles for as long as it went out, where there is room", "[plan]") {
  Document document = striking();
  for (const auto& [kind, release] :
       {std::pair(rig::LimbKind::tail, 40.0), {rig::LimbKind::feeler, 40.0}, {rig::LimbKind::wing, 8.0}}) {
    document.body.limbs[0].kind = kind;
    const ClipGround ground = plannedGround(document);
    const auto releaseOf = [&](double startFrame, double endFrame) {
      return *plannedSettings(planFor(ground, {stroke("left-arm", startFrame, endFrame, 9.0)})).releaseFrames;
    };
    CAPTURE(release);
    CHECK(releaseOf(0, 40) == Approx(release));
    CHECK(releaseOf(40, 84) == Approx(5.0)); // a frame before the clip ends
    AutoSettings settings = twiceAsLong();
    settings.style.overshoot = 0.2;
    const bool follows = kind != rig::LimbKind::wing;
    CHECK((plannedSettings(planFor(ground, {stroke("left-arm", 0, 20, 9.0)}, settings)).overshoot == 0.0) ==
          follows);
    const std::vector<rig::Moment> beside{stroke("right-arm", 0, 10, 20.0), stroke("left-arm", 0, 10, 15.0)};
    CHECK(shareOf(planFor(ground, beside), 1) == Approx(follows ? 1.0 / 3.0 : 1.0));
  }
}

TEST_CASE("In a loop from frame 1 on a way back ends when the foot is put down past the seam", "[plan]") {
  Document document = striking();
  document.body.limbs[0].kind = rig::LimbKind::leg;
  ClipGround ground = plannedGround(document);
  ground.wraps = true;
  AutoSettings settings = twiceAsLong();
  settings.style.release = 9.0;
  const auto releaseFor = [&](double turn, const Vec2& stand) {
    ground.turnFrames = turn;
    ground.stands["left-arm"] = {stand};
    return *plannedSettings(planFor(ground, {stroke("left-arm", 70, 84, 9.0)}, settings)).releaseFrames;
  };
  CHECK(releaseFor(90.0, {3.0, 30.0}) == Approx(9.0));
  CHECK(releaseFor(89.0, {3.0, 30.0}) == Approx(8.0));
  CHECK(releaseFor(89.0, {4.0, 30.0}) == Approx(9.0));
}

TEST_CASE("A way back ends before the next stroke of its limb has gone half of its way", "[plan]") {
  const Document document = striking();
  ClipGround ground = plannedGround(document);
  AutoSettings settings = twiceAsLong();
  settings.style.release = 5.0;
  const std::vector<rig::Moment> moments{stroke("left-arm", 0, 10, 9.0), stroke("left-arm", 40, 50, 9.0),
                                         stroke("right-arm", 12, 20, 8.9)};
  const AutoPlan plan = planFor(ground, moments, settings);
  CHECK(*plannedSettings(plan, 0).releaseFrames == Approx(35.0)); // to frame 45
  CHECK(*plannedSettings(plan, 1).releaseFrames == Approx(39.0)); // to a frame before the clip's end
  ground.wraps = true;
  const AutoPlan loop = planFor(ground, moments, settings);
  CHECK(*plannedSettings(loop, 0).releaseFrames == Approx(35.0));
  CHECK(*plannedSettings(loop, 1).releaseFrames == Approx(45.0)); // round to frame 5
  CHECK(loop.loops);
  CHECK_FALSE(plan.loops);
}

TEST_CASE("An overshoot is left by the square of what a way back has of a third of a second", "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  AutoSettings settings = twiceAsLong();
  settings.style.overshoot = 0.8;
  for (const auto& [release, left] : {std::pair(1.0, 0.8), {0.5, 0.8}, {0.25, 0.8 * 0.25}}) {
    settings.style.release = release; // of 20 frames; a third of a second are ten
    CHECK(plannedSettings(planFor(ground, {stroke("left-arm", 0, 20, 9.0)}, settings)).overshoot ==
          Approx(left));
  }
}

TEST_CASE("A stroke right after a stronger one of its limb is left out unless the limb itself comes back",
          "[plan]") {
  Document document = striking();
  const ClipGround ground = plannedGround(document);
  const auto second = [&](const std::string& limb, double startFrame, double endFrame) {
    return planFor(ground, {stroke("left-arm", 0, 10, 9.0), stroke(limb, startFrame, endFrame, 8.5)})
        .leftOut[1];
  };
  // From frame 10 on the arm itself goes all of its way back by 20: by 14 two fifths of it and a little more.
  CHECK(second("left-arm", 12, 20).empty()); // half of it is frame 16, six frames away
  CHECK(second("left-arm", 10, 14) == noWayBack);
  CHECK(second("right-arm", 10, 14).empty());
}

TEST_CASE("The spine goes along with a strike of a limb on it, pulled the limb's way, a little later",
          "[plan]") {
  const Document document = striking();
  const ClipGround ground = plannedGround(document);
  AutoSettings settings = twiceAsLong();
  settings.style.spread.trunk = 0.5;
  settings.style.spread.lateFrames = 2.0; // of 1/24 s: 2.5 frames, which are 3
  const AutoPlan plan = planFor(ground, {stroke("left-arm", 0, 10, 9.0)}, settings);
  REQUIRE(plan.trails.size() == 2);
  const PlannedTrail& spine = plan.trails[1];
  CHECK(spine.follows);
  CHECK(spine.moment == 0);
  CHECK(spine.trail.limb == "spine");
  CHECK(spine.trail.settings.startFrame == 3.0);
  CHECK(spine.trail.settings.endFrame == 13.0);
  CHECK(spine.trail.settings.scale == 1.0);
  const Vec3 way = ground.reachOf("left-arm", 10.0) - ground.reachOf("left-arm", 0.0);
  const double pull = 0.5 * findLimb(document, "spine")->restLength; // Half of what a spine twice as long
                                                                     // gets.
  REQUIRE(spine.trail.settings.spheres.size() == 5);
  CHECK(spine.trail.controlFrames.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double part = static_cast<double>(i) / 4.0;
    const rig::SphereOffset& sphere = spine.trail.settings.spheres[i];
    CHECK(sphere.frame == Approx(3.0 + 10.0 * part));
    const double share = part * part * (3.0 - 2.0 * part);
    CHECK(glm::length(sphere.offset - share * pull * glm::normalize(way)) < 1e-9);
  }

  const auto trails = [&](const std::vector<rig::Moment>& moments) {
    return planFor(ground, moments, settings).trails.size();
  };
  CHECK(trails({stroke("left-arm", 0, 10, 3.0)}) == 2); // Half of a full stroke is one.
  CHECK(trails({stroke("left-arm", 0, 10, 2.9)}) == 1);
  rig::Moment round = stroke("left-arm", 0, 10, 9.0);
  round.kind = rig::MomentKind::cycle;
  CHECK(trails({round}) == 1);
  CHECK(trails({stroke("spine", 0, 10, 9.0)}) == 1);
  CHECK(trails({stroke("left-arm", 0, 10, 9.0), stroke("spine", 5, 15, 9.0)}) == 2);  // It has its own there,
  CHECK(trails({stroke("left-arm", 0, 10, 9.0), stroke("spine", 30, 40, 9.0)}) == 3); // and not there.
  CHECK(trails({stroke("left-arm", 40, 50, 9.0), stroke("spine", 20, 30, 9.0)}) == 3); // It is back by then,
  CHECK(trails({stroke("left-arm", 40, 50, 9.0), stroke("spine", 24, 34, 9.0)}) == 2); // and not yet.
  CHECK(trails({stroke("left-arm", 70, 85, 9.0)}) == 2);
  CHECK(trails({stroke("left-arm", 70, 86, 9.0)}) == 1); // Past the clip's end but two frames.
}

TEST_CASE("A share of a trail's exaggeration is that of its scale and of its spheres' pull", "[plan]") {
  rig::TrailSettings settings;
  settings.scale = 1.8;
  settings.spheres = {{2.0, Vec3(1.0, 2.0, 3.0), {}}, {4.0, Vec3(-1.0, 0.0, 0.0), {}}};
  const rig::TrailSettings quarter = withShare(settings, 0.25);
  CHECK(quarter.scale == Approx(1.2));
  CHECK(quarter.spheres[0].offset == Vec3(0.25, 0.5, 0.75));
  CHECK(quarter.spheres[1].offset == Vec3(-0.25, 0.0, 0.0));
  CHECK(withShare(settings, 1.0) == settings);
  CHECK(withShare(settings, 0.0).scale == 1.0);
}

TEST_CASE("A trail acts until the end of its way back, which is as long as its range where none is told",
          "[plan]") {
  rig::TrailSettings settings;
  settings.startFrame = 4.0;
  settings.endFrame = 10.0;
  CHECK(windowOf(settings) == Vec2(4.0, 16.0));
  settings.releaseFrames = 2.5;
  CHECK(windowOf(settings) == Vec2(4.0, 12.5));
}

TEST_CASE("A trail that is left out takes along what follows it and the grips that it leads", "[plan]") {
  const auto planOf = [] {
    AutoPlan plan;
    plan.leftOut.resize(3);
    for (const auto& [moment, limb, follows] : {std::tuple(0U, "left-arm", false),
                                                {1U, "right-arm", false},
                                                {0U, "spine", true},
                                                {2U, "left-arm", false}}) {
      PlannedTrail trail;
      trail.moment = moment;
      trail.trail.limb = limb;
      trail.follows = follows;
      trail.trail.settings.startFrame = 10.0 * moment;
      plan.trails.push_back(trail);
      rig::Grip grip;
      grip.leader = limb;
      grip.time.rangeFrames = Vec2(10.0 * moment, 100.0);
      plan.holds.grips.push_back(grip);
    }
    return plan;
  };
  AutoPlan plan = planOf();
  leaveOut(plan, 0, "why");
  CHECK(plan.leftOut == std::vector<std::string>{"why", "", ""});
  REQUIRE(plan.trails.size() == 2);
  CHECK(plan.trails[0].trail.limb == "right-arm");
  CHECK(plan.trails[1].moment == 2);
  REQUIRE(plan.holds.grips.size() == 3);
  CHECK(plan.holds.grips[0].leader == "right-arm");
  CHECK(plan.holds.grips[2].time.rangeFrames.x == 20.0); // Another one of the same limb stays.

  plan = planOf();
  leaveOut(plan, 3, "later"); // Told where its moment is.
  CHECK(plan.leftOut == std::vector<std::string>{"", "", "later"});
  CHECK(plan.trails.size() == 3);

  plan = planOf();
  leaveOut(plan, 2, "why"); // One that follows goes alone.
  CHECK(plan.leftOut[0].empty());
  CHECK(plan.trails.size() == 3);
  CHECK(plan.holds.grips.size() == 4);
}

TEST_CASE("A clear stroke of what is neither a wing nor a chain is something that a body does in flight",
          "[plan]") {
  const auto does = [](rig::LimbKind kind, const rig::Moment& moment) {
    rig::Limb limb;
    limb.kind = kind;
    return isAct(limb, moment);
  };
  const rig::Moment clear = stroke("limb", 0, 10, 2.41);
  CHECK(does(rig::LimbKind::arm, clear));
  CHECK(does(rig::LimbKind::leg, clear));
  for (const rig::LimbKind kind : {rig::LimbKind::wing, rig::LimbKind::spine, rig::LimbKind::neck,
                                   rig::LimbKind::tail, rig::LimbKind::feeler}) {
    CHECK_FALSE(does(kind, clear));
  }
  CHECK_FALSE(does(rig::LimbKind::leg, stroke("limb", 0, 10, 2.39)));
  rig::Moment round = clear;
  round.kind = rig::MomentKind::cycle;
  CHECK_FALSE(does(rig::LimbKind::leg, round));
}

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "app/auto/clip_ground.h"
#include "app/auto/planned_trail.h"
#include "app/auto/poses_of_strokes.h"
#include "app/auto/whole_check.h"
#include "app/evaluate/clip_moments.h"
#include "app/evaluate/evaluate.h"
#include "app/standing_floor.h"
#include "rig/motion/floor.h"
#include "rig/reach/bind_places.h"
#include "rig/trail/release.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

// A serpent without a mesh: its tail is up, its belly on the ground, and its neck rears up until frame 12.
Document rearing() {
  Document document = test::boxer();
  Scene scene;
  std::vector<NodeIndex> joints;
  for (const Vec3& place : {Vec3(0.0, 0.5, 0.0), Vec3(0.0, -0.5, 0.3), Vec3(0.0, 0.0, 0.4),
                            Vec3(0.0, 0.1, 0.4), Vec3(0.0, 0.1, 0.4)}) {
    const NodeIndex parent = joints.empty() ? NodeIndex::none : joints.back();
    joints.push_back(test::addNode(scene, "Joint" + std::to_string(joints.size()), parent, place));
  }
  document.scene = std::make_shared<const Scene>(std::move(scene));
  rig::Limb spine;
  static_cast<rig::LimbPlace&>(spine) = rig::biped::spine;
  spine.id = rig::limbName(rig::biped::spine);
  spine.endNode = joints.back();
  spine.joints.assign(joints.begin(), joints.end() - 1);
  spine.restLength = 1.8;
  document.body.limbs = {spine};
  document.body.hips = joints.front();
  document.body.plan = "serpent";
  document.body.height = 1.0;
  Track rears = turnsOf(document, "spine");
  rears.node = joints[2];
  for (int frame = 0; frame <= 30; ++frame) {
    const double up = rig::smoothstep((frame - 4.0) / 8.0) - rig::smoothstep((frame - 14.0) / 12.0);
    addKey(rears, frame, glm::angleAxis(1.2 * up, Vec3(-1.0, 0.0, 0.0)));
  }
  return withTracks(document, {rears});
}

// The stepper, whose right foot slides along the ground over the whole clip.
Document slider() {
  const Document document = twoLeggedStepper();
  Track slide = turnsOf(document, "right-leg");
  for (int frame = 0; frame <= 50; ++frame) {
    addKey(slide, frame, glm::angleAxis(0.13 * std::sin(0.2 * frame), Vec3(1.0, 0.0, 0.0)));
  }
  const Track step = *document.clips->front().tracks.front();
  return withTracks(document, {step, slide});
}

// Two legs that step on the spot in a loop of 24 frames, the right one first: forwards until frame 7, and
// back along the ground.
Document treadmill() {
  Document document = slider();
  std::vector<Track> tracks;
  for (const auto& [leg, ahead] : {std::pair("right-leg", 0.0), {"left-leg", 12.0}}) {
    Track steps = turnsOf(document, leg);
    for (int frame = 0; frame <= 24; ++frame) {
      const double phase = std::fmod(frame + ahead, 24.0);
      const double part =
          phase < 7.0 ? rig::smoothstep(phase / 7.0) : 1.0 - rig::smoothstep((phase - 7.0) / 17.0);
      addKey(steps, frame, glm::angleAxis(0.8 * (part - 0.5), Vec3(-1.0, 0.0, 0.0)));
    }
    tracks.push_back(steps);
  }
  return withTracks(document, tracks);
}

// The boxer with wings for arms, in the air: they beat down until frame 12, past the plumb line, where longer
// ones would meet below the body.
Document beater() {
  Document document = test::boxer();
  for (rig::Limb& limb : document.body.limbs) {
    if (isArm(limb)) {
      limb.kind = rig::LimbKind::wing;
      limb.id = rig::limbName(limb);
    }
  }
  std::vector<Track> tracks;
  for (const double side : {1.0, -1.0}) {
    tracks.push_back(turnsOf(document, side > 0.0 ? "left-wing" : "right-wing"));
    for (int frame = 0; frame <= 30; ++frame) {
      const double down = rig::smoothstep((frame - 6.0) / 6.0) - rig::smoothstep((frame - 16.0) / 14.0);
      addKey(tracks.back(), frame, glm::angleAxis(side * (0.8 - 2.55 * down), Vec3(0.0, 0.0, 1.0)));
    }
  }
  return withTracks(document, tracks);
}

// The stepper with a tail, and with long wings for arms that reach below its feet, on its way down a slope.
// Of the wings and the tail those named go straight down.
enum class Down {
  once,     ///< For 8 frames.
  beating,  ///< All the time, in the air.
  hanging,  ///< From beginning to end, on a perch.
  sinking,  ///< Likewise, while the whole body goes down.
  crouching ///< All the time, on a perch on which the foot stands while the body sinks.
};

Document descending(const std::vector<const char*>& limbs, Down goes) {
  Document document = stepper();
  std::vector<Track> tracks{*document.clips->front().tracks.front()};
  Scene scene = *document.scene;
  for (rig::Limb& limb : document.body.limbs) {
    if (isArm(limb)) {
      limb.kind = rig::LimbKind::wing;
      limb.id = rig::limbName(limb);
      scene.nodes[at(limb.joints[1])].rest.translation.x *= 6.0;
    }
  }
  rig::Limb tail;
  tail.kind = rig::LimbKind::tail;
  tail.id = "tail";
  tail.joints = {test::addNode(scene, "Tail", document.body.hips, {0.0, 0.0, -0.2})};
  tail.endNode = test::addNode(scene, "TailTip", tail.joints.front(), {0.0, 0.0, -1.7});
  tail.restLength = 1.7;
  document.body.limbs.push_back(tail);
  document.scene = std::make_shared<const Scene>(std::move(scene));
  for (const char* const limb : limbs) {
    tracks.push_back(turnsOf(document, limb));
    const Vec3 axis = std::string(limb) == "tail"        ? Vec3(-1.0, 0.0, 0.0)
                      : std::string(limb) == "left-wing" ? Vec3(0.0, 0.0, -1.0)
                                                         : Vec3(0.0, 0.0, 1.0);
    for (int frame = 0; frame <= 50; ++frame) {
      const double down = goes == Down::hanging || goes == Down::sinking ? 1.0
                          : goes != Down::once       ? 0.5 - 0.5 * std::cos(2.0 * pi * frame / 10.0)
                          : frame < 20 || frame > 27 ? 0.0
                                                     : 1.0;
      addKey(tracks.back(), frame, glm::angleAxis(0.5 * pi * down, axis));
    }
  }
  Track& sinks = tracks.emplace_back();
  sinks.node = document.body.hips;
  sinks.channel = Channel::translation;
  sinks.width = 3;
  sinks.times = {0.0F, 50.0F / 30.0F};
  const float lower = goes == Down::beating || goes == Down::hanging ? 1.0F : 0.7F;
  sinks.values = {0.0F, 1.0F, 0.0F, 0.0F, lower, 0.0F};
  if (goes == Down::crouching) {
    Track foot = sinks;
    foot.node = findLimb(document, "left-leg")->endNode;
    const Vec3 rest = document.scene->nodes[at(foot.node)].rest.translation;
    for (std::size_t i = 0; i < foot.values.size(); ++i) {
      foot.values[i] = static_cast<float>(rest[static_cast<int>(i % 3)]) + (i == 4 ? 1.0F - lower : 0.0F);
    }
    tracks.front() = foot; // It does not step.
  }
  return withTracks(document, tracks);
}

StandingFloor standingOf(const Document& document) {
  return standingFloor(document, 0, rig::bindPlaces(*document.scene));
}

// A leg that steps in a loop of 24 frames: down at its seam, it stands until frame 6.
Document seamStepper() {
  Document document = stepper();
  Track steps = turnsOf(document, "left-leg");
  for (int frame = 0; frame <= 24; ++frame) {
    const double back = rig::smoothstep((frame - 6.0) / 8.0) - rig::smoothstep((frame - 14.0) / 10.0);
    addKey(steps, frame, glm::angleAxis(0.4 - 0.8 * back, Vec3(-1.0, 0.0, 0.0)));
  }
  return withTracks(document, {steps});
}

rig::Moment stepOf(const char* leg, rig::MomentKind kind, double start, double tip) {
  rig::Moment moment;
  moment.limb = leg;
  moment.kind = kind;
  moment.startFrame = start;
  moment.tipFrame = moment.endFrame = tip;
  moment.strength = 20.0;
  return moment;
}

rig::Moment strokeOf(const char* limb, double start, double tip, double strength) {
  rig::Moment moment = stepOf(limb, rig::MomentKind::stroke, start, tip);
  moment.strength = strength;
  return moment;
}

} // namespace

TEST_CASE("A step of a cycle is taken back while the ground carries the foot, without an overshoot") {
  const AutoSettings style = in("Rubber hose");
  REQUIRE(style.style.overshoot > 0.0);
  const auto settingsOf = [&](rig::MomentKind kind) {
    const AutoClip made = exaggerateClip(treadmill(), 0, {stepOf("right-leg", kind, 0.0, 7.0)}, style);
    REQUIRE(made.document.trails.size() == 1);
    return made.document.trails.front().settings;
  };
  const rig::TrailSettings step = settingsOf(rig::MomentKind::cycle);
  CHECK(*step.releaseFrames >= 15.0); // of 17 to the next step
  CHECK(step.overshoot == 0.0);
  CHECK(*settingsOf(rig::MomentKind::stroke).releaseFrames < 10.0);
}

TEST_CASE("The way back of a step is not exaggerated too, and that of an arm is") {
  for (const auto& [limb, both] : {std::pair("right-leg", false), {"left-arm", true}}) {
    CAPTURE(limb);
    Document document = treadmill();
    std::vector<Track> tracks;
    for (const CopyOnWrite<Track>& track : document.clips->front().tracks) {
      tracks.push_back(*track);
    }
    Track arm = turnsOf(document, "left-arm");
    for (int frame = 0; frame <= 24; ++frame) {
      const double part = 0.5 - 0.5 * std::cos(frame * 3.14159265 / 4.0);
      addKey(arm, frame, glm::angleAxis(0.8 * part, Vec3(0.0, 0.0, 1.0)));
    }
    tracks.push_back(arm);
    document = withTracks(document, tracks);
    const AutoClip made = exaggerateClip(
        document, 0,
        {stepOf(limb, rig::MomentKind::cycle, 0.0, 4.0), stepOf(limb, rig::MomentKind::cycle, 4.0, 8.0)},
        in("Subtle"));
    REQUIRE(made.moments.size() == 2);
    CHECK(made.moments.front().trailId > 0);
    CHECK((made.moments.back().why != "there is no room for the way back") == both);
  }
}

TEST_CASE(
    "One arm that waves while the other rests needs no partner, and one whose partner is left out does") {
  const Document both = swinger();
  Document waving = withTracks(both, {*both.clips->front().tracks.front()});
  std::vector<rig::Moment> moments = momentsOf(waving, 0);
  REQUIRE_FALSE(moments.empty());
  for (rig::Moment& moment : moments) {
    REQUIRE(moment.limb == "left-arm");
    moment.kind = rig::MomentKind::cycle;
  }
  const AutoClip alone = exaggerateClip(waving, 0, moments, in("Opera"));
  CHECK(momentAt(alone, "left-arm", 7.0).scale == Approx(1.4));
  AutoSettings settings = in("Opera");
  settings.beside = {moments.front()};
  settings.beside.front().limb = "right-arm";
  const AutoClip lame = exaggerateClip(waving, 0, moments, settings);
  CHECK(momentAt(lame, "left-arm", 7.0).why == "the limb on the other side cannot do the same");
}

TEST_CASE("What is weak beside the strongest is done all the same where the other side does it too") {
  const Document striking = withTracks(
      test::boxer(), {turnsOfPunch(test::boxer(), "left-arm"), turnsOfPunch(test::boxer(), "right-arm")});
  const rig::Moment punch = momentsOf(test::boxer(), 0).front();
  rig::Moment strongest = punch, left = punch, right = punch;
  strongest.strength = 60.0;
  left.strength = 10.0;
  right.limb = "right-arm";
  right.strength = 8.0;
  AutoSettings opera = in("Opera");
  opera.beside = {strongest};
  const AutoClip both = exaggerateClip(striking, 0, {left, right}, opera);
  CHECK(both.moments.back().scale > 1.05);
  CHECK(both.moments.back().scale == Approx(both.moments.front().scale));
  left.strength = 8.0;
  const AutoClip none = exaggerateClip(striking, 0, {left, right}, opera);
  CHECK(none.moments.back().why == "it is weak beside the clip's strongest");
}

TEST_CASE("A weak partner that is left out after all takes no room from the way back before it") {
  const Document striking = withTracks(
      test::boxer(), {turnsOfPunch(test::boxer(), "left-arm"), turnsOfPunch(test::boxer(), "right-arm")});
  rig::Moment left = momentsOf(test::boxer(), 0).front();
  left.startFrame = 4.0;
  left.tipFrame = left.endFrame = 9.0;
  left.strength = 60.0;
  rig::Moment right = left;
  right.limb = "right-arm";
  rig::Moment back = left;
  back.startFrame = 9.0;
  back.tipFrame = back.endFrame = 13.0;
  back.strength = 10.0;
  rig::Moment weakBack = back;
  weakBack.limb = "right-arm";
  weakBack.strength = 8.0;
  const auto wayBack = [&](const std::vector<rig::Moment>& moments) {
    const AutoClip made = exaggerateClip(striking, 0, moments, in("Subtle"));
    REQUIRE(made.moments[1].trailId > 0);
    CHECK((moments.size() < 4 || made.moments.back().trailId == 0)); // the style hardly stretches it
    return findTrail(made.document, made.moments[1].trailId)->settings.releaseFrames.value();
  };
  CHECK(wayBack({left, right, back, weakBack}) == wayBack({left, right, back}));
}

TEST_CASE("Of two strokes that leave each other no time both sides choose the same") {
  const Document striking = withTracks(
      test::boxer(), {turnsOfPunch(test::boxer(), "left-arm"), turnsOfPunch(test::boxer(), "right-arm")});
  const AutoClip made =
      exaggerateClip(striking, 0,
                     {strokeOf("left-arm", 4.0, 9.0, 31.0), strokeOf("right-arm", 9.0, 13.0, 30.0),
                      strokeOf("right-arm", 4.0, 9.0, 29.0), strokeOf("left-arm", 9.0, 13.0, 28.0)},
                     in("Average"));
  CHECK(made.moments[0].trailId > 0);
  CHECK(made.moments[2].trailId > 0);
  CHECK(made.moments[2].scale == Approx(made.moments[0].scale));
  CHECK(made.moments[1].trailId == 0);
}

TEST_CASE("What goes along with the other side waits for a stronger stroke of its limb that is its own") {
  const Document striking = withTracks(
      test::boxer(), {turnsOfPunch(test::boxer(), "left-arm"), turnsOfPunch(test::boxer(), "right-arm")});
  const auto outcome = [&](double own) {
    const AutoClip made =
        exaggerateClip(striking, 0,
                       {strokeOf("left-arm", 4.0, 9.0, 50.0), strokeOf("right-arm", 9.0, 13.0, own),
                        strokeOf("right-arm", 4.0, 9.0, 30.0)},
                       in("Average"));
    return std::pair(made.moments[1].trailId > 0, made.moments[2].trailId > 0);
  };
  CHECK(outcome(45.0) == std::pair(true, false));
  CHECK(outcome(38.0) == std::pair(false, true)); // does not lead as the left arm does
}

TEST_CASE("A step that is put down at the seam of a loop is back in its place by then") {
  const Document document = seamStepper();
  const ClipGround ground = clipGround(document, 0);
  REQUIRE(ground.wraps);
  REQUIRE_FALSE(ground.standsOf("left-leg").empty());
  REQUIRE(ground.standsOf("left-leg").front().x <= 1.0);
  const AutoClip made =
      exaggerateClip(document, 0, {stepOf("left-leg", rig::MomentKind::cycle, 14.0, 24.0)}, in("Opera"));
  REQUIRE(made.document.trails.size() == 1);
  const rig::TrailSettings& settings = made.document.trails.front().settings;
  CHECK(settings.endFrame <= 22.0);
  CHECK(settings.endFrame + *settings.releaseFrames <= 25.0);
}

TEST_CASE(
    "Wings that beat far below a body in the air know no floor, and get longer without passing each other") {
  const Document before = beater();
  CHECK(standingOf(before).flies);
  CHECK_FALSE(standingOf(withTracks(before, {*swinger().clips->front().tracks.front()})).flies);
  const AutoClip made = exaggerated(before, in("Duck Amuck"));
  CHECK(momentAt(made, "left-wing", 12.0).scale == Approx(2.0));
  CHECK(momentAt(made, "right-wing", 12.0).scale == Approx(2.0));
  const rig::MotionState motion = prepareMotion(made.document, 0);
  const auto endOf = [&](const char* wing, double frame) {
    return rig::endPosition(*findLimb(before, wing), evaluate(made.document, motion, frame / 30.0));
  };
  double nearest = 1.0;
  for (double frame = 0.0; frame <= 30.0; frame += 1.0) {
    nearest = std::min(nearest, endOf("left-wing", frame).x - endOf("right-wing", frame).x);
  }
  CHECK(nearest >= 0.0);
  CHECK(endOf("left-wing", 12.0).y < 0.5); // 0.9 in the clip
}

TEST_CASE("A body that walks down a slope and dips its tail or a wing keeps its floor, and one in the air "
          "has none") {
  for (const char* const limb : {"tail", "left-wing"}) {
    CAPTURE(limb);
    const StandingFloor walks = standingOf(descending({limb}, Down::once));
    CHECK_FALSE(walks.flies);
    CHECK(walks.floor.has_value());
  }
  const Document beating = descending({"left-wing", "right-wing"}, Down::beating);
  REQUIRE(rig::standingHeight(*beating.scene, beating.clips->front(), *findLimb(beating, "left-leg")));
  CHECK(standingOf(beating).flies); // though its leg hangs still
  CHECK_FALSE(standingOf(beating).floor);
  CHECK_FALSE(floorHeight(beating, 0));
}

TEST_CASE(
    "A body on a perch, whose wings hang below its feet or beat there while a foot stands, does not fly") {
  for (const Down goes : {Down::hanging, Down::crouching}) {
    const Document perched = descending({"left-wing", "right-wing"}, goes);
    CAPTURE(static_cast<int>(goes));
    CHECK_FALSE(standingOf(perched).flies);
    CHECK(standingOf(perched).floor.has_value());
  }
  CHECK_FALSE(standingOf(descending({"left-wing", "right-wing"}, Down::sinking)).flies);
}

TEST_CASE("A trail along the ground that cannot be done takes its own grips along when it is left out") {
  const Document document = test::boxer();
  AutoPlan plan;
  plan.leftOut.resize(1);
  plan.trails.resize(1);
  plan.trails.front().trail = test::withNewTrail(document, {"right-arm", 4.0, 10.0, 1.5}).trails.front();
  plan.trails.front().trail.settings.axes = {true, false, true};
  for (const Vec2& range : {Vec2(4.0, 10.0), Vec2(0.0, 3.0)}) {
    rig::Grip& grip = plan.holds.grips.emplace_back();
    grip.leader = "right-arm";
    grip.time.rangeFrames = range;
  }
  const std::vector<rig::Moment> moments{stepOf("right-arm", rig::MomentKind::stroke, 4.0, 10.0)};
  settle(clipGround(document, 0), moments, in("Average"), plan);
  CHECK(plan.leftOut.front() == "the limb's end does not move along the active axes");
  REQUIRE(plan.holds.grips.size() == 1);
  CHECK(plan.holds.grips.front().time.rangeFrames.x == 0.0);
}

TEST_CASE("Arms that close straight across, with little or no way forwards, get less and not much less") {
  for (const auto& [from, to, least] : {std::tuple(1.42, 1.72, 1.05), {1.226, 1.6, 1.6}}) {
    std::vector<Track> tracks;
    for (const double side : {1.0, -1.0}) {
      tracks.push_back(turnsOf(test::boxer(), side > 0.0 ? "left-arm" : "right-arm"));
      for (const auto& [frame, angle] :
           {std::pair(0, from), {6, from}, {12, to}, {18, to - 0.02}, {30, from}}) {
        addKey(tracks.back(), frame, glm::angleAxis(angle, Vec3(0.0, -side, 0.0)));
      }
    }
    const AutoClip made = exaggerateClip(withTracks(test::boxer(), tracks), 0,
                                         {stepOf("left-arm", rig::MomentKind::stroke, 6.0, 12.0),
                                          stepOf("right-arm", rig::MomentKind::stroke, 6.0, 12.0)},
                                         in("Rubber hose"));
    CAPTURE(from);
    CHECK(strongest(made).trailId > 0);
    CHECK(strongest(made).scale > least);
    CHECK_FALSE(strongest(made).why.empty());
  }
}

TEST_CASE("What goes too low and has no way along the ground gets less, and is not left out") {
  const Document still = test::boxer();
  Track strikes = turnsOf(still, "left-arm"); // straight down, less low than the other arm hangs
  for (int frame = 0; frame <= 30; ++frame) {
    const double down = rig::smoothstep((frame - 6.0) / 6.0) - rig::smoothstep((frame - 16.0) / 14.0);
    addKey(strikes, frame, glm::angleAxis(-0.9 * down, Vec3(0.0, 0.0, 1.0)));
  }
  Track hangs = turnsOf(still, "right-arm");
  addKey(hangs, 0, glm::angleAxis(0.5 * pi, Vec3(0.0, 0.0, 1.0)));
  addKey(hangs, 30, glm::angleAxis(0.5 * pi, Vec3(0.0, 0.0, 1.0)));
  const AutoClip made = exaggerateClip(withTracks(still, {strikes, hangs}), 0,
                                       {stepOf("left-arm", rig::MomentKind::stroke, 6.0, 12.0)}, in("Opera"));
  CHECK(strongest(made).trailId > 0);
  CHECK(strongest(made).scale > 1.05);
  CHECK(strongest(made).scale < 1.2);
  CHECK(strongest(made).why == "it would go through the floor");
}

TEST_CASE("An arm that is shaken comes back by itself, though it is out again at once") {
  const Document still = test::boxer();
  Track shaken = turnsOf(still, "left-arm");
  for (const auto& [frame, angle] : {std::pair(0, 0.0), {4, 1.2}, {7, 0.0}, {10, 1.2}, {20, 0.0}}) {
    addKey(shaken, frame, glm::angleAxis(angle, Vec3(0.0, -1.0, 0.0)));
  }
  const AutoClip made = exaggerateClip(withTracks(still, {shaken}), 0,
                                       {stepOf("left-arm", rig::MomentKind::stroke, 7.0, 10.0),
                                        stepOf("left-arm", rig::MomentKind::stroke, 0.0, 4.0)},
                                       in("Average"));
  CHECK(made.moments.front().scale == Approx(2.008));
  CHECK(made.moments.back().scale == Approx(2.008));
}

TEST_CASE("Both sides do the same at once where one of them takes longer, and where the torso turns") {
  const Document still = withTracks(
      test::boxer(), {turnsOfPunch(test::boxer(), "left-arm"), turnsOfPunch(test::boxer(), "right-arm")});
  rig::Moment left = momentsOf(test::boxer(), 0).front();
  left.startFrame = 2.0;
  left.tipFrame = left.endFrame = 8.0;
  rig::Moment right = left;
  right.limb = "right-arm";
  right.tipFrame = right.endFrame = 12.0;
  const ClipGround ground = clipGround(still, 0);
  CHECK(arePartners(ground, left, right));
  right.tipFrame = 15.0;
  CHECK_FALSE(arePartners(ground, left, right));
  Document turning = swinger();
  Track hips = turnsOf(turning, "spine");
  for (int frame = 0; frame <= 24; ++frame) {
    addKey(hips, frame, glm::angleAxis(0.9 * std::cos(2.0 * pi * frame / 24.0), Vec3(0.0, 1.0, 0.0)));
  }
  std::vector<Track> tracks{hips};
  for (const auto& track : turning.clips->front().tracks) {
    tracks.push_back(*track);
  }
  turning = withTracks(turning, tracks);
  left.kind = right.kind = rig::MomentKind::cycle;
  left.startFrame = 0.0;
  left.tipFrame = 7.0;
  right.startFrame = 12.0;
  right.tipFrame = 19.0;
  const ClipGround turned = clipGround(turning, 0);
  CHECK(arePartners(turned, left, right));
  CHECK(arePartners(turned, right, left));
  CHECK_FALSE(arePartners(turned, left, left));
}

TEST_CASE("A foot that slides along the ground while another one stands carries too, for what is no step") {
  const ClipGround ground = clipGround(slider(), 0);
  REQUIRE_FALSE(ground.standsOf("left-leg").empty());
  CHECK(ground.standsOf("left-leg", true).size() == ground.standsOf("left-leg").size());
  const std::vector<Vec2>& slides = ground.standsOf("right-leg", true);
  const auto isIn = [](const std::vector<Vec2>& stands, double frame) {
    return std::ranges::any_of(stands, [&](const Vec2& s) { return s.x <= frame && frame <= s.y; });
  };
  CHECK(isIn(slides, 3.0));
  CHECK_FALSE(isIn(ground.standsOf("right-leg"), 3.0));
  CHECK_FALSE(isIn(slides, 20.0)); // the other one is in the air
  rig::Moment moment;
  moment.limb = "right-leg";
  moment.startFrame = 0.0;
  moment.tipFrame = moment.endFrame = 8.0;
  moment.strength = 20.0;
  moment.kind = rig::MomentKind::stroke;
  CHECK(exaggerateClip(slider(), 0, {moment}, in("Opera")).moments.front().why ==
        "the foot carries the body there");
  moment.kind = rig::MomentKind::cycle;
  CHECK(exaggerateClip(slider(), 0, {moment}, in("Opera")).moments.front().why !=
        "the foot carries the body there");
}

TEST_CASE(
    "A limb that is short for its body goes farther, and one of a creature is no longer than that is large") {
  Document document = test::boxer();
  const auto scaleIn = [&](double size, const char* plan, const char* style) {
    document.body.size = size;
    document.body.plan = plan;
    return strongest(exaggerated(document, in(style))).scale;
  };
  CHECK(scaleIn(0.6 / 0.3, "biped", "Opera") == Approx(1.4));
  CHECK(scaleIn(0.6 / 0.2, "biped", "Opera") == Approx(1.5));
  CHECK(scaleIn(0.6 / 0.05, "biped", "Opera") == Approx(1.6));
  CHECK(scaleIn(0.6 / 0.8, "biped", "Opera") == Approx(1.4));
  CHECK(scaleIn(0.6 / 0.8, "quadruped", "Opera") == Approx(1.25));
}

TEST_CASE(
    "A chain as long as the body goes all the way with a third of an arm's reaches, and is not turned") {
  for (const auto& [limb, scale] : {std::pair("spine", 1.4), {"left-arm", 1.0 + 0.4 / 3.0}}) {
    const Document still = test::boxer();
    Track track = turnsOf(still, limb);
    for (const auto& [frame, angle] : {std::pair(0, 0.8), {5, 0.6}, {10, 0.1}, {20, 0.7}}) {
      addKey(track, frame, glm::angleAxis(angle, Vec3(0.0, 0.0, 1.0)));
    }
    rig::Moment moment = momentsOf(still, 0).front();
    moment.limb = limb;
    moment.strength = 1.0;
    const AutoClip made = exaggerateClip(withTracks(still, {track}), 0, {moment}, in("Opera"));
    REQUIRE(made.trailIds.size() == 1);
    CAPTURE(limb);
    CHECK(strongest(made).scale == Approx(scale));
    CHECK((made.document.trails.front().settings.turnLimitDegrees == 0.0) == (std::string(limb) == "spine"));
  }
}

TEST_CASE("A serpent that rears up keeps its belly on the ground, and what has legs may leave it") {
  Document document = rearing();
  AutoPlan plan;
  plan.trails.resize(1);
  plan.trails.front().trail = test::withNewTrail(document, {"spine", 4.0, 12.0, 1.5}).trails.front();
  const std::vector<Fault> faults = faultsOf(clipGround(document, 0), in("Rubber hose", 2.0), plan);
  REQUIRE(faults.size() == 1);
  CHECK(faults.front().kind == FaultKind::lifted);
  rig::Limb leg = document.body.limbs.front();
  static_cast<rig::LimbPlace&>(leg) = rig::biped::leftLeg;
  leg.id = rig::limbName(rig::biped::leftLeg);
  leg.joints = {document.body.hips};
  leg.endNode = NodeIndex{1};
  document.body.limbs.push_back(leg);
  CHECK(faultsOf(clipGround(document, 0), in("Rubber hose", 2.0), plan).empty());
}

TEST_CASE("A serpent that crawls along the ground is left alone, one that rears up is not") {
  Document document = rearing();
  document.body.height = 2.0;
  const ClipGround ground = clipGround(document, 0);
  const rig::Limb& spine = *findLimb(document, "spine");
  CHECK(crawls(ground, spine, {0.0, 4.0}));
  CHECK_FALSE(crawls(ground, spine, {0.0, 12.0}));
  CHECK_FALSE(crawls(ground, spine, {12.0, 13.0}));
  const auto whyNot = [&](double start, double tip) {
    return planTrails(ground, {strokeOf("spine", start, tip, 5.0)}, in("Opera"), {}).leftOut[0];
  };
  CHECK(whyNot(0.0, 4.0) == "the body crawls along the ground by it");
  CHECK(whyNot(4.0, 12.0).empty());
  ClipGround walking = ground; // what has legs does not crawl
  walking.soles["left-leg"] = {0.0};
  CHECK_FALSE(crawls(walking, spine, {0.0, 4.0}));
}

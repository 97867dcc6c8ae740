// Steps of walks and runs in a style: as long as the ground, the time before a foot is put down and the seam
// of a loop allow, and what swings beside them.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "app/auto/clip_ground.h"
#include "app/auto/planned_trail.h"
#include "app/auto/whole_check.h"
#include "app/evaluate/evaluate.h"
#include "rig/trail/release.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

/// Legs and arms that swing in a loop of 24 frames, both sides at once: forwards until frame 7, and back. The
/// hips go up and down so that the feet slide along the ground. On each shin is a heel so far behind the
/// foot, which goes down as the leg leans forwards.
double angleAt(double frame) {
  return 0.8 *
         ((frame < 7.0 ? rig::smoothstep(frame / 7.0) : 1.0 - rig::smoothstep((frame - 7.0) / 17.0)) - 0.5);
}

Document walker(double heel = 0.1) {
  Document document = twoLeggedStepper();
  Scene scene = *document.scene;
  for (const char* const leg : {"left-leg", "right-leg"}) {
    const rig::Limb& limb = *findLimb(document, leg);
    const double length = limb.joints.size() > 1 ? 0.5 : 1.0;
    Primitive shoe;
    for (const Vec3& point :
         {Vec3(0.0, -length, 0.0), Vec3(0.0, -length, -heel), Vec3(0.02, -length, -heel)}) {
      shoe.positions.emplace_back(point);
    }
    shoe.indices = {0, 1, 2};
    scene.nodes[at(limb.joints.back())].mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({"shoe", {shoe}, {}});
  }
  document.scene = std::make_shared<const Scene>(std::move(scene));
  std::vector<Track> tracks;
  Track hips;
  hips.node = document.body.hips;
  hips.channel = Channel::translation;
  hips.width = 3;
  for (const char* const name : {"right-leg", "left-leg", "left-arm", "right-arm"}) {
    Track track = turnsOf(document, name);
    const std::string limb(name);
    const Vec3 axis = limb == "left-arm"    ? Vec3(0.0, -1.0, 0.0)
                      : limb == "right-arm" ? Vec3(0.0, 1.0, 0.0)
                                            : Vec3(-1.0, 0.0, 0.0);
    for (int frame = 0; frame <= 24; ++frame) {
      addKey(track, frame, glm::angleAxis(angleAt(frame), axis));
    }
    tracks.push_back(track);
  }
  for (int frame = 0; frame <= 24; ++frame) {
    hips.times.push_back(static_cast<float>(frame / 30.0));
    for (const double value : {0.0, std::cos(angleAt(frame)), 0.0}) {
      hips.values.push_back(static_cast<float>(value));
    }
  }
  tracks.push_back(hips);
  return withTracks(document, tracks);
}

rig::Moment roundOf(const char* limb, double start, double tip, double strength = 20.0) {
  return {limb, rig::MomentKind::cycle, start, tip, tip, strength};
}

std::vector<rig::Moment> bothSteps() {
  return {roundOf("right-leg", 0, 7), roundOf("left-leg", 0, 7)};
}

double lowestIn(const Document& document) {
  const ClipGround ground = clipGround(document, 0);
  const rig::MotionState motion = prepareMotion(document, 0);
  double lowest = 1e9;
  for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
    lowest = std::min(lowest, ground.lowestVertexIn(evaluate(document, motion, frame / 30.0))->y);
  }
  return lowest;
}

} // namespace

TEST_CASE("A step along the ground whose heel would be a little below it is lifted by as much") {
  const Document before = walker(0.1);
  const double height = before.body.height;
  const AutoClip made = exaggerateClip(before, 0, bothSteps(), in("Opera"));
  for (const AutoMoment& step : made.moments) {
    REQUIRE(step.trailId > 0);
    CHECK(step.isLevel);
    CHECK(step.scale > 1.35); // of 1.4; without the lift 1.2
    const std::vector<rig::SphereOffset>& spheres = findTrail(made.document, step.trailId)->settings.spheres;
    REQUIRE_FALSE(spheres.empty());
    CHECK(spheres.back().offset.y > 0.005 * height);
    CHECK(spheres.back().offset.y <= 0.03 * height);
    CHECK(spheres.front().offset.y == 0.0);
  }
  CHECK(lowestIn(made.document) > lowestIn(before) - 0.0015 * height);
}

TEST_CASE("A foot that would have to hang in the air to be above the ground steps less far") {
  const Document before = walker(0.2);
  const double height = before.body.height;
  const AutoClip made = exaggerateClip(before, 0, bothSteps(), in("Opera"));
  for (const AutoMoment& step : made.moments) {
    CHECK(step.scale < 1.3);
    CHECK(step.why == "it would go through the floor");
    CHECK(findTrail(made.document, step.trailId)->settings.spheres.back().offset.y <= 0.03 * height);
  }
  CHECK(lowestIn(made.document) > lowestIn(before) - 0.0015 * height);
}

TEST_CASE("A foot that is lifted already is lifted no higher than three hundredths of the height, and steps "
          "less far") {
  const Document document = walker(0.2);
  const double most = 0.03 * document.body.height;
  // Lifted so far that by itself it looks right: what is missing would take more than is left.
  for (const double before : {0.02, 0.028}) {
    AutoPlan plan;
    plan.leftOut.resize(2);
    for (const char* const leg : {"right-leg", "left-leg"}) {
      PlannedTrail planned;
      planned.moment = plan.trails.size();
      planned.trail = withNewTrail(document, {leg, 0.0, 7.0, 1.4}).trails.front();
      planned.trail.settings.axes = {true, false, true};
      pullAlong(planned, {0.0, before * document.body.height, 0.0});
      plan.trails.push_back(planned);
    }
    settle(clipGround(document, 0), bothSteps(), in("Opera"), plan);
    REQUIRE(plan.trails.size() == 2);
    for (const PlannedTrail& step : plan.trails) {
      CHECK(step.trail.settings.spheres.back().offset.y <= most);
      CHECK(step.trail.settings.spheres.back().offset.y > 0.75 * most);
      CHECK(step.trail.settings.scale < 1.3);
      CHECK(step.trail.settings.scale > 1.1);
    }
    CHECK(plan.trails.front().why == "it would go through the floor");
  }
}

TEST_CASE("How far below the floor a limb is, is told of the frame where it is most") {
  const Document document = walker(0.1);
  AutoPlan plan;
  plan.trails.resize(1);
  plan.trails.front().trail = withNewTrail(document, {"right-leg", 0.0, 7.0, 1.4}).trails.front();
  plan.trails.front().trail.settings.axes = {true, false, true};
  const ClipGround ground = clipGround(document, 0);
  const std::vector<Fault> faults = faultsOf(ground, in("Opera"), plan);
  const auto floor = std::ranges::find(faults, FaultKind::floor, &Fault::kind);
  REQUIRE(floor != faults.end());
  Document alone = document;
  alone.trails = {plan.trails.front().trail};
  CHECK(floor->depth == Approx(ground.groundHeight() - lowestIn(alone)).margin(1e-4));
}

TEST_CASE("A foot's lift is no exaggeration: both sides are as long though one of them is lifted") {
  const Document document = walker(0.0);
  AutoPlan plan;
  plan.leftOut.resize(2);
  for (const char* const leg : {"right-leg", "left-leg"}) {
    PlannedTrail planned;
    planned.moment = plan.trails.size();
    planned.trail = withNewTrail(document, {leg, 0.0, 7.0, 1.3}).trails.front();
    planned.trail.settings.axes = {true, false, true};
    plan.trails.push_back(planned);
  }
  pullAlong(plan.trails.front(), {0.0, 0.02, 0.0});
  settle(clipGround(document, 0), bothSteps(), in("Opera"), plan);
  REQUIRE(plan.trails.size() == 2);
  const rig::TrailSettings& lifted = plan.trails.front().trail.settings;
  CHECK(lifted.scale == Approx(plan.trails.back().trail.settings.scale));
  // The lift goes along with a range that has changed.
  REQUIRE(lifted.spheres.size() == 5);
  CHECK(lifted.spheres.back().frame == lifted.endFrame);
  CHECK(lifted.spheres.back().offset.y == Approx(0.02));
}

TEST_CASE("Arms that swing along with steps gain twice as much as these at most, a strike all of its own") {
  AutoSettings settings = in("Opera");
  settings.style.leg = {1.0, 1.1, 5.0};
  for (const rig::MomentKind kind : {rig::MomentKind::cycle, rig::MomentKind::stroke}) {
    std::vector<rig::Moment> moments = bothSteps();
    moments.push_back({"left-arm", kind, 0, 7, 7, 20.0});
    const AutoClip made = exaggerateClip(walker(0.0), 0, moments, settings);
    REQUIRE(made.moments[0].scale > 1.05);
    const double most = 1.0 + 2.0 * (made.moments[0].scale - 1.0);
    CHECK(made.moments[2].scale == Approx(kind == rig::MomentKind::cycle ? most : 1.4));
  }
  // What swings less than that, and what has no steps beside it, keeps what it has.
  settings.style.arm = {1.0, 1.15, 5.0};
  std::vector<rig::Moment> moments = bothSteps();
  moments.push_back(roundOf("left-arm", 0, 7));
  CHECK(exaggerateClip(walker(0.0), 0, moments, settings).moments[2].scale == Approx(1.15));
  CHECK(exaggerateClip(walker(0.0), 0, {roundOf("left-arm", 0, 7)}, in("Opera")).moments[0].scale ==
        Approx(1.4));
}

TEST_CASE("Wings that carry a body gain no more than what it does in flight, and a nod does not hold them") {
  Document document = stepper();
  for (rig::Limb& limb : document.body.limbs) {
    limb.kind = isArm(limb) ? rig::LimbKind::wing : limb.kind;
  }
  std::vector<Track> tracks{*document.clips->front().tracks.front()};
  for (const char* const name : {"left-arm", "right-arm"}) {
    tracks.push_back(turnsOf(document, name));
    const double side = name == std::string("right-arm") ? 1.0 : -1.0;
    for (const auto& [frame, angle] : {std::pair(0, 0.8), {10, 0.8}, {20, -0.4}, {40, 0.8}, {50, 0.8}}) {
      addKey(tracks.back(), frame, glm::angleAxis(side * angle, Vec3(0.0, 0.0, 1.0)));
    }
  }
  document = withTracks(document, tracks);
  AutoSettings settings = in("Opera");
  settings.style.leg = {1.0, 1.2, 5.0};
  const auto beatBeside = [&](double strength) {
    const AutoClip made = exaggerateClip(document, 0,
                                         {roundOf("left-arm", 10, 20, 5.0),
                                          roundOf("right-arm", 10, 20, 5.0),
                                          {"left-leg", rig::MomentKind::stroke, 10, 25, 25, strength}},
                                         settings);
    CHECK(made.moments[0].scale == Approx(made.moments[1].scale));
    return std::pair(made.moments[0].scale, made.moments[2].scale);
  };
  const auto [beat, act] = beatBeside(6.0);
  CHECK(act > 1.15);
  CHECK(beat == Approx(act));
  CHECK(beatBeside(2.3).first == Approx(1.4)); // of 2.4 that an act of a leg has at least
}

TEST_CASE("A step that is put down within a sixth of a second gets less, by the square of that share") {
  const Document document = walker();
  ClipGround ground{document, 0};
  ground.framesPerSecond = 30.0;
  ground.lastFrame = 24.0;
  ground.turnFrames = 24.0;
  ground.limbs = allLimbs(document);
  for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
    ground.places.push_back(placesOf(ground.limbs, evaluateOriginal(document, 0, frame / 30.0)));
  }
  const auto gainBefore = [&](double stand, rig::MomentKind kind) {
    ground.stands["right-leg"] = {{stand, stand + 3.0}};
    rig::Moment step = roundOf("right-leg", 0, 7);
    step.kind = kind;
    const AutoPlan plan = planTrails(ground, {step}, in("Opera"), {});
    REQUIRE(plan.trails.size() == 1);
    CHECK(*plan.trails.front().trail.settings.releaseFrames <= stand - 7.0);
    return plan.trails.front().trail.settings.scale - 1.0;
  };
  const double all = gainBefore(20.0, rig::MomentKind::cycle);
  CHECK(all == Approx(0.4));
  CHECK(gainBefore(12.0, rig::MomentKind::cycle) == Approx(all));
  CHECK(gainBefore(11.0, rig::MomentKind::cycle) == Approx(all * 16.0 / 25.0));
  CHECK(gainBefore(9.0, rig::MomentKind::cycle) == Approx(all * 4.0 / 25.0));
  CHECK(gainBefore(9.0, rig::MomentKind::stroke) == Approx(all)); // a reach for the ground
}

TEST_CASE("A step that turns back sharply at the seam of a loop is over before it") {
  const Document start = stepper();
  Track thigh = turnsOf(start, "left-leg");
  Track knee = thigh;
  knee.node = findLimb(start, "left-leg")->joints[1];
  for (int frame = 0; frame <= 24; ++frame) {
    const double out = std::abs(12 - frame);
    addKey(thigh, frame, glm::angleAxis(0.03 * (out - 6.0), Vec3(-1.0, 0.0, 0.0)));
    addKey(knee, frame, glm::angleAxis(0.5 + 0.1 * out, Vec3(1.0, 0.0, 0.0)));
  }
  const Document before = withTracks(start, {thigh, knee});
  const AutoClip made = exaggerateClip(before, 0, {roundOf("left-leg", 12, 22)}, in("Opera"));
  REQUIRE(made.document.trails.size() == 1);
  const rig::TrailSettings& settings = made.document.trails.front().settings;
  CHECK(settings.scale == Approx(1.4));
  CHECK(settings.endFrame == 20.0);
  CHECK(*settings.releaseFrames == 3.0); // a tenth of a second
  CHECK(settings.lingerFrames == 0.0);
  // One that would hardly have started by then gets less, and so does one that would be over much earlier
  // than the step of the other side.
  for (const auto& [begin, tip] : {std::pair(19.0, 22.0), {12.0, 24.0}}) {
    const AutoClip late = exaggerateClip(before, 0, {roundOf("left-leg", begin, tip)}, in("Opera"));
    CHECK(late.moments.front().scale < 1.4);
    for (const rig::Trail& trail : late.document.trails) {
      CHECK(trail.settings.endFrame > 20.0);
    }
  }
}

TEST_CASE("A clip in which limbs go round is a loop, though one of four is not back in its place") {
  const auto tipWith = [](int limbsOff, rig::MomentKind kind, double off = 0.3) {
    const Document document = twoLeggedStepper();
    std::vector<Track> tracks{turnsOf(document, "left-arm")};
    for (int frame = 0; frame <= 24; ++frame) {
      const double angle = 0.4 * std::cos(2.0 * pi * frame / 24.0);
      addKey(tracks.back(), frame, glm::angleAxis(angle, Vec3(0.0, -1.0, 0.0)));
    }
    const std::vector<const char*> limbs{"right-arm", "spine"};
    for (int i = 0; i < limbsOff; ++i) {
      tracks.push_back(turnsOf(document, limbs[static_cast<std::size_t>(i)]));
      addKey(tracks.back(), 0.0, glm::angleAxis(0.0, Vec3(0.0, 0.0, 1.0)));
      addKey(tracks.back(), 24.0, glm::angleAxis(off, Vec3(0.0, 0.0, 1.0)));
    }
    const AutoClip made = exaggerateClip(withTracks(document, tracks), 0,
                                         {{"left-arm", kind, 12.0, 24.0, 24.0, 20.0}}, in("Opera"));
    REQUIRE(made.document.trails.size() == 1);
    return made.document.trails.front().settings.endFrame;
  };
  CHECK(tipWith(0, rig::MomentKind::stroke) >= 23.0);     // it is one
  CHECK(tipWith(1, rig::MomentKind::cycle) >= 23.0);      // of five limbs
  CHECK(tipWith(1, rig::MomentKind::cycle, 1.0) == 20.0); // far off, as an arm that is raised
  CHECK(tipWith(2, rig::MomentKind::cycle) == 20.0);
  CHECK(tipWith(1, rig::MomentKind::stroke) == 20.0);
}

TEST_CASE("Steps that are too little to be seen hold back no arms beside them") {
  AutoSettings settings = in("Opera");
  settings.style.leg = {1.0, 1.03, 5.0};
  std::vector<rig::Moment> moments = bothSteps();
  moments.push_back(roundOf("left-arm", 0, 7));
  const AutoClip made = exaggerateClip(walker(0.0), 0, moments, settings);
  CHECK(made.moments[0].trailId == 0);
  CHECK(made.moments[1].trailId == 0);
  CHECK(made.moments[2].scale == Approx(1.4));
}

TEST_CASE("What comes again too weakly to be seen makes no other one as weak") {
  const Document start = test::boxer();
  Track arm = turnsOf(start, "left-arm");
  for (const auto& [frame, angle] :
       {std::pair(0, 0.0), {10, 1.2}, {25, 0.0}, {40, 0.0}, {50, 1.2}, {70, 0.0}}) {
    addKey(arm, frame, glm::angleAxis(angle, Vec3(0.0, -1.0, 0.0)));
  }
  AutoSettings settings = in("Opera");
  settings.style.arm = {1.0, 1.2, 5.0};
  const auto scalesWith = [&](double strength) {
    const AutoClip made =
        exaggerateClip(withTracks(start, {arm}), 0,
                       {roundOf("left-arm", 0, 10), roundOf("left-arm", 40, 50, strength)}, settings);
    return std::pair(made.moments[0].scale, made.moments[1].trailId > 0 ? made.moments[1].scale : 0.0);
  };
  CHECK(scalesWith(3.2).first == Approx(1.2));
  CHECK(scalesWith(3.2).second == 0.0);
  const auto [first, second] = scalesWith(11.0);
  CHECK(first == Approx(1.0 + 0.2 * 11.0 / 12.0));
  CHECK(second == Approx(first));
}

TEST_CASE(
    "Where one side goes along the ground, or keeps its bend, the other one that does the same does too") {
  const Document document = withTracks(
      test::boxer(), {turnsOfPunch(test::boxer(), "left-arm"), turnsOfPunch(test::boxer(), "right-arm")});
  const std::vector<rig::Moment> moments{{"left-arm", rig::MomentKind::stroke, 0.0, 10.0, 10.0, 20.0},
                                         {"right-arm", rig::MomentKind::stroke, 0.0, 10.0, 10.0, 20.0}};
  const auto settled = [&](bool oneIsLevel, bool oneKeeps, std::size_t which) {
    AutoPlan plan;
    plan.leftOut.resize(2);
    for (const rig::Moment& moment : moments) {
      PlannedTrail planned;
      planned.moment = plan.trails.size();
      planned.trail = withNewTrail(document, {moment.limb, 0.0, 10.0, 1.2}).trails.front();
      rig::TrailSettings& settings = planned.trail.settings;
      settings.axes[1] = !(oneIsLevel && planned.moment == which);
      settings.bend = oneKeeps && planned.moment == which ? rig::Bend::keep : rig::Bend::straighten;
      plan.trails.push_back(planned);
    }
    settle(clipGround(document, 0), moments, in("Opera"), plan);
    REQUIRE(plan.trails.size() == 2);
    CHECK(plan.trails[0].trail.settings.axes == plan.trails[1].trail.settings.axes);
    CHECK(plan.trails[0].trail.settings.bend == plan.trails[1].trail.settings.bend);
    return plan.trails[0].trail.settings;
  };
  for (const std::size_t which : {0U, 1U}) {
    CHECK_FALSE(settled(true, false, which).axes[1]);
    CHECK(settled(false, true, which).bend == rig::Bend::keep);
  }
  CHECK(settled(false, false, 0).axes[1]);
  CHECK(settled(false, false, 0).bend == rig::Bend::straighten);
}

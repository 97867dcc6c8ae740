#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/gtc/quaternion.hpp>

#include "app/auto/clip_ground.h"
#include "app/auto/exaggerate_clip.h"
#include "app/edits/trail/style_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/clip_moments.h"
#include "app/evaluate/evaluate.h"
#include "core/math/rotation.h"
#include "rig/trail/release.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

/// Straight length of the left arm at a frame over what the source has.
double armRatio(const Document& document, double frame) {
  const rig::Limb& arm = *findLimb(document, "left-arm");
  const double seconds = frame / clipOf(document, 0).framesPerSecond;
  return rig::limbLength(arm, evaluate(document, prepareMotion(document, 0), seconds)) /
         rig::limbLength(arm, evaluateOriginal(document, 0, seconds));
}

// The left arm strikes forwards and down to the lowest place that anything has.
Document lowStriker() {
  Document document = test::boxer();
  Track track = turnsOf(document, "left-arm");
  for (int frame = 0; frame <= 30; ++frame) {
    const double struck = rig::smoothstep((frame - 6.0) / 6.0) - rig::smoothstep((frame - 18.0) / 12.0);
    addKey(track, frame,
           glm::angleAxis(0.1 + 1.2 * struck, Vec3(0.0, -1.0, 0.0)) *
               glm::angleAxis(0.6 - 1.5 * struck, Vec3(0.0, 0.0, 1.0)));
  }
  return withTracks(std::move(document), {track});
}

// Both arms close in front of the chest, so far that longer ones would pass each other, and open again.
Document closer() {
  const Document document = test::boxer();
  std::vector<Track> tracks;
  for (const bool isLeft : {true, false}) {
    tracks.push_back(turnsOf(document, isLeft ? "left-arm" : "right-arm"));
    for (const auto& [frame, angle] : {std::pair(0, 0.0), {6, 0.1}, {12, 1.65}, {18, 1.6}, {30, 0.0}}) {
      addKey(tracks.back(), frame, glm::angleAxis(angle, Vec3(0.0, isLeft ? -1.0 : 1.0, 0.0)));
    }
  }
  return withTracks(document, std::move(tracks));
}

Vec3 handAt(const Document& document, const rig::MotionState& motion, const char* limb, double frame) {
  return rig::endPosition(*findLimb(document, limb), evaluate(document, motion, frame / 30.0));
}

// How sharply a hand turns from the end of the loop to its start, in metres per second.
double seamTurn(const Document& document, const char* limb) {
  const rig::MotionState motion = prepareMotion(document, 0);
  const auto hand = [&](double frame) { return handAt(document, motion, limb, frame); };
  return glm::length(hand(24.0) - hand(23.75) - hand(0.25) + hand(0.0)) * 120.0;
}

// Between the ways that a limb points in the source and in what was made of it.
double degreesTurned(const Document& made, const char* name, double frame) {
  const rig::Limb& limb = *findLimb(made, name);
  const auto way = [&](const FrameState& state) {
    return rig::endPosition(limb, state) - positionOf(state.worlds[at(limb.joints.front())]);
  };
  return angleBetween(way(evaluateOriginal(made, 0, frame / 30.0)),
                      way(evaluate(made, prepareMotion(made, 0), frame / 30.0))) *
         180.0 / pi;
}

} // namespace

TEST_CASE("In a loop a strong stroke is as long as its style says, whatever a weaker one does at the seam") {
  const Document before = swinger();
  const AutoClip made = exaggerated(before, in("Opera"));
  CHECK(momentAt(made, "left-arm", 7.0).scale == Approx(1.4));
  CHECK(momentAt(made, "right-arm", 19.0).scale == Approx(1.4));
  for (const char* limb : {"left-arm", "right-arm"}) {
    const rig::MotionState motion = prepareMotion(made.document, 0);
    CHECK(glm::length(handAt(made.document, motion, limb, 24.0) - handAt(made.document, motion, limb, 0.0)) <
          1e-6);
    CHECK(seamTurn(made.document, limb) - seamTurn(before, limb) < 0.1);
  }
}

TEST_CASE("What is struck at the seam of a loop keeps its exaggeration over it") {
  const AutoClip made = exaggerated(swinger(), in("Rubber hose"));
  const AutoMoment& back = momentAt(made, "left-arm", 24.0);
  REQUIRE(back.trailId > 0);
  const rig::TrailSettings& settings = findTrail(made.document, back.trailId)->settings;
  CHECK(settings.endFrame == 23.0);
  CHECK(settings.lingerFrames == Approx(2.0).margin(1e-4));
  CHECK(isLooping(made.document, 0));
  CHECK(made.madeLoop);
  CHECK(back.scale > 1.03);
}

TEST_CASE("What would open the seam of a loop where it is straightened keeps its bend, and gets longer") {
  Document before = swinger();
  std::vector<Track> tracks;
  for (const auto& track : before.clips->front().tracks) {
    tracks.push_back(*track);
  }
  for (const char* const limb : {"left-arm", "right-arm"}) {
    Track elbow = turnsOf(before, limb);
    elbow.node = findLimb(before, limb)->joints[1];
    for (int frame = 0; frame <= 24; ++frame) {
      const double bend = 0.3 - 0.28 * std::cos(2.0 * pi * frame / 24.0 - 0.6);
      const double side = limb == std::string("left-arm") ? -1.0 : 1.0;
      addKey(elbow, frame, glm::angleAxis(bend, Vec3(0.0, side, 0.0)));
    }
    tracks.push_back(elbow);
  }
  before = withTracks(before, tracks);
  const AutoClip made = exaggerated(before, in("Rubber hose"));
  const AutoMoment& back = momentAt(made, "left-arm", 24.0);
  REQUIRE(back.trailId > 0);
  CHECK(findTrail(made.document, back.trailId)->settings.bend == rig::Bend::keep);
  CHECK(back.scale > 1.1);
  const int strike = momentAt(made, "left-arm", 8.0).trailId;
  CHECK(findTrail(made.document, strike)->settings.bend == rig::Bend::straighten);
}

TEST_CASE("Left and right get the same in a loop, each for what the other does half a turn later") {
  const AutoClip made = exaggerated(swinger(), in("Rubber hose"));
  CHECK(momentAt(made, "left-arm", 7.0).scale == momentAt(made, "right-arm", 19.0).scale);
  CHECK(momentAt(made, "left-arm", 24.0).scale == momentAt(made, "right-arm", 12.0).scale);
  CHECK(momentAt(made, "left-arm", 7.0).scale > momentAt(made, "left-arm", 24.0).scale);
}

TEST_CASE("A strike to the lowest place of a clip is exaggerated along the ground, and goes no lower") {
  const Document before = lowStriker();
  const AutoClip made = exaggerated(before, in("Opera"));
  const AutoMoment& strike = strongest(made);
  REQUIRE(strike.trailId > 0);
  CHECK(strike.isLevel);
  const double tip = findTrail(made.document, strike.trailId)->settings.endFrame;
  CHECK(armRatio(made.document, tip) > 1.15); // as far as it may be turned
  const rig::MotionState motion = prepareMotion(made.document, 0);
  const Vec3 hand = handAt(made.document, motion, "left-arm", tip);
  const Vec3 source =
      rig::endPosition(*findLimb(before, "left-arm"), evaluateOriginal(before, 0, tip / 30.0));
  CHECK(hand.y == Approx(source.y).margin(1e-5));
  CHECK_FALSE(strongest(exaggerated(swinger(), in("Opera"))).isLevel);
}

TEST_CASE("A limb that is exaggerated still points where it pointed, and is longer") {
  for (const Document& before : {test::boxer(), swinger(), lowStriker()}) {
    const AutoClip made = exaggerated(before, in("Rubber hose"));
    int longer = 0;
    for (const AutoMoment& one : made.moments) {
      if (one.trailId == 0) {
        continue;
      }
      const double tip = findTrail(made.document, one.trailId)->settings.endFrame;
      CHECK(degreesTurned(made.document, one.moment.limb.c_str(), tip) < (one.isLevel ? 25.1 : 8.1));
      const rig::Limb& limb = *findLimb(made.document, one.moment.limb);
      const rig::MotionState motion = prepareMotion(made.document, 0);
      CHECK(rig::limbLength(limb, evaluate(made.document, motion, tip / 30.0)) ==
            Approx(one.scale * rig::limbLength(limb, evaluateOriginal(before, 0, tip / 30.0))).epsilon(1e-3));
      ++longer;
    }
    CHECK(longer > 0);
  }
}

TEST_CASE("What is weak beside the clip's strongest gets as much less, and what comes near to it gets all") {
  const Document before = test::boxer();
  rig::Moment punch = momentsOf(before, 0).front();
  rig::Moment other = punch;
  other.limb = "right-arm";
  other.strength = 60.0;
  const Document striking =
      withTracks(before, {turnsOfPunch(before, "left-arm"), turnsOfPunch(before, "right-arm")});
  const auto scaleBeside = [&](double strength) {
    punch.strength = strength;
    return exaggerateClip(striking, 0, {other, punch}, in("Opera")).moments.back().scale;
  };
  CHECK(scaleBeside(60.0) == Approx(1.4));
  CHECK(scaleBeside(48.0) == Approx(1.4));
  CHECK(scaleBeside(18.0) == Approx(1.2));
  CHECK(scaleBeside(8.0) == 1.0);
}

TEST_CASE("What both sides do at once is as large on both, and what one does later is its own") {
  const Document before = test::boxer();
  const rig::Moment punch = momentsOf(before, 0).front();
  const Document both =
      withTracks(before, {turnsOfPunch(before, "left-arm"), turnsOfPunch(before, "right-arm")});
  rig::Moment other = punch;
  other.limb = "right-arm";
  other.strength = 0.5 * punch.strength;
  const AutoClip together = exaggerateClip(both, 0, {punch, other}, in("Opera"));
  CHECK(together.moments.front().scale == Approx(together.moments.back().scale));
  CHECK(together.moments.front().scale < 1.4);
  other.startFrame += 4.0;
  const AutoClip apart = exaggerateClip(both, 0, {punch, other}, in("Opera"));
  CHECK(apart.moments.front().scale == Approx(1.4));
}

TEST_CASE("What is asked for alone is as weak beside the rest of the clip as together with it") {
  const Document before = test::boxer();
  const rig::Moment punch = momentsOf(before, 0).front();
  rig::Moment stronger = punch;
  stronger.strength = 3.0 * punch.strength;
  AutoSettings settings = in("Opera");
  const double alone = exaggerateClip(before, 0, {punch}, settings).moments.front().scale;
  settings.beside = {stronger};
  CHECK(alone == Approx(1.4));
  CHECK(exaggerateClip(before, 0, {punch}, settings).moments.front().scale == Approx(1.0 + 0.4 / 1.8));
}

TEST_CASE("A clip that only idles is left alone") {
  const Document before = test::boxer();
  rig::Moment breath = momentsOf(before, 0).front();
  breath.strength = 0.9;
  const AutoClip idle = exaggerateClip(before, 0, {breath}, in("Opera"));
  CHECK(idle.moments.front().why == "it is too weak to be an action");
  CHECK(idle.trailIds.empty());
  breath.strength = 1.1;
  CHECK(exaggerateClip(before, 0, {breath}, in("Opera")).trailIds.size() == 1);
}

TEST_CASE("A moment that can have no trail makes no other one weak, unless it has one of its own") {
  const Document before = test::boxer();
  const rig::Moment punch = momentsOf(before, 0).front();
  rig::Moment strong = punch;
  strong.strength = 20.0 * punch.strength;
  for (const char* limb : {rig::wholeBody, "tail"}) {
    strong.limb = limb;
    CHECK(exaggerateClip(before, 0, {strong, punch}, in("Opera")).moments.back().scale == Approx(1.4));
  }
  strong.limb = "spine";
  const Document own = test::withNewTrail(before, {"spine", strong.startFrame, strong.endFrame, 1.1});
  CHECK(exaggerateClip(own, 0, {strong, punch}, in("Opera")).moments.back().why ==
        "it is weak beside the clip's strongest");
}

TEST_CASE("A moment that turns out to be impossible makes no other one weak") {
  const rig::Moment punch = momentsOf(test::boxer(), 0).front();
  rig::Moment strong = punch;
  strong.strength = 20.0 * punch.strength;
  strong.limb = "right-arm"; // which rests
  const AutoClip made = exaggerateClip(test::boxer(), 0, {strong, punch}, in("Opera"));
  CHECK(made.moments.front().trailId == 0);
  CHECK(made.moments.back().scale == Approx(1.4));
}

TEST_CASE(
    "A loop that leaves out its last frame, since that is the first, is a loop, and half of one is none") {
  CHECK(clipGround(swinger(), 0).endsMeet);
  CHECK(clipGround(swinger(23), 0).endsMeet);
  CHECK_FALSE(clipGround(swinger(20), 0).endsMeet);
  CHECK_FALSE(clipGround(swinger(12), 0).endsMeet);
  CHECK(exaggerated(swinger(23), in("Opera")).madeLoop);
}

TEST_CASE("A clip that is no loop ends in the pose in which it did, and comes back to that without a jump") {
  for (const int last : {12, 20}) {
    const Document before = swinger(last);
    const AutoClip made = exaggerated(before, in("Opera"));
    REQUIRE_FALSE(made.trailIds.empty());
    CHECK_FALSE(made.madeLoop);
    const rig::MotionState motion = prepareMotion(made.document, 0);
    const double end = last / 30.0;
    for (const char* const arm : {"left-arm", "right-arm"}) {
      CAPTURE(last, arm);
      const rig::Limb& limb = *findLimb(before, arm);
      CHECK(glm::length(rig::endPosition(limb, evaluate(made.document, motion, end)) -
                        rig::endPosition(limb, evaluateOriginal(before, 0, end))) < 1e-6);
    }
    for (const rig::Trail& trail : made.document.trails) {
      CHECK(trail.settings.endFrame <= last - 2.0);
      REQUIRE(trail.settings.releaseFrames);
      CHECK(trail.settings.endFrame + *trail.settings.releaseFrames <= last);
    }
  }
}

TEST_CASE("A way back takes a sixth of a second or more where there is room for it") {
  const AutoClip made = exaggerated(lowStriker(), in("Snappy")); // whose way back is short
  const rig::TrailSettings& settings = made.document.trails.front().settings;
  REQUIRE(settings.releaseFrames);
  CHECK(*settings.releaseFrames - settings.lingerFrames ==
        Approx(std::max(0.4 * (settings.endFrame - settings.startFrame), 30.0 / 6.0)));
}

namespace {

/// The boxer whose left arm is raised to the side from frame 10 to 14 and is down again so many frames later.
Document raiser(double framesDown) {
  const Document boxer = test::boxer();
  Track arm = turnsOf(boxer, "left-arm");
  const Quat rest = boxer.scene->nodes[static_cast<std::size_t>(arm.node.value)].rest.rotation;
  const Quat raised = glm::angleAxis(1.2, Vec3(0.0, 0.0, 1.0)) * rest;
  for (double frame = 0.0; frame <= 60.0; frame += 1.0) {
    const double part = frame <= 14.0
                            ? rig::smoothstep(std::clamp((frame - 10.0) / 4.0, 0.0, 1.0))
                            : 1.0 - rig::smoothstep(std::clamp((frame - 14.0) / framesDown, 0.0, 1.0));
    addKey(arm, frame, glm::slerp(rest, raised, part));
  }
  return withTracks(boxer, {arm});
}

} // namespace

TEST_CASE("A stroke that would leave a stronger one no time to come back is left out, unless the limb goes "
          "as far itself") {
  const AutoClip far = exaggerated(raiser(4.0), in("Duck Amuck", 1.5));
  CHECK(momentAt(far, "left-arm", 14.0).scale > 2.0);
  CHECK(momentAt(far, "left-arm", 18.0).why == "there is no room for the way back");
  REQUIRE(far.document.trails.size() == 1);
  CHECK(far.document.trails.front().settings.releaseFrames >= 5.0);
  const AutoClip near = exaggerated(raiser(4.0), in("Subtle"));
  CHECK(momentAt(near, "left-arm", 18.0).trailId > 0);
  CHECK(near.document.trails.size() == 2);
}

TEST_CASE("A style's overshoot needs a third of a second: in half of that a quarter of it is left") {
  const rig::Style style = in("Rubber hose").style;
  REQUIRE(style.overshoot > 0.0);
  for (const double framesDown : {4.0, 30.0}) {
    for (const double strength : {0.2, 1.0}) {
      CAPTURE(framesDown, strength);
      const AutoClip made = exaggerated(raiser(framesDown), AutoSettings{style, strength});
      REQUIRE_FALSE(made.document.trails.empty());
      const rig::TrailSettings& settings = made.document.trails.front().settings;
      const double back = *settings.releaseFrames - settings.lingerFrames;
      const double time = std::min(1.0, back / 10.0);
      CHECK(settings.overshoot == Approx(time * time * style.overshoot));
      CHECK(settings.overshoot < style.overshoot);
    }
  }
}

TEST_CASE("Arms that close in front of the chest get longer forwards, and do not pass each other") {
  const Document before = closer();
  for (const auto& [style, scale] : {std::pair("Subtle", 1.2), {"Rubber hose", 2.5}}) {
    const AutoClip made = exaggerated(before, in(style));
    const rig::MotionState motion = prepareMotion(made.document, 0);
    double nearest = 1.0;
    for (double frame = 0.0; frame <= 30.0; frame += 1.0) {
      nearest = std::min(nearest, handAt(made.document, motion, "left-arm", frame).x -
                                      handAt(made.document, motion, "right-arm", frame).x);
    }
    CAPTURE(style, strongest(made).scale, strongest(made).why);
    CHECK(nearest >= 0.0);
    CHECK(strongest(made).scale == Approx(scale));
  }
}

TEST_CASE(
    "A bent arm straightens before it stretches in a style, and keeps its bend where the style says so") {
  rig::Style kept = in("Opera").style;
  kept.bend = rig::Bend::keep;
  for (const auto& [style, bend] :
       {std::pair(in("Opera"), rig::Bend::straighten), {AutoSettings{kept, 1.0}, rig::Bend::keep}}) {
    for (const rig::Trail& trail : exaggerated(swinger(), style).document.trails) {
      CHECK(trail.settings.bend == bend);
    }
  }
}

TEST_CASE("A strike with a bent arm keeps its bend, unless its elbow would be thrown out") {
  for (const auto& [elbow, bend] :
       {std::pair(1.4, rig::Bend::keep), {0.4, rig::Bend::straighten}, {1.9, rig::Bend::straighten}}) {
    Document before = test::boxer();
    Track bent = turnsOf(before, "left-arm");
    bent.node = findLimb(before, "left-arm")->joints[1];
    addKey(bent, 0.0, glm::angleAxis(elbow, Vec3(0.0, -1.0, 0.0)));
    before = withTracks(before, {bent, turnsOfPunch(before, "left-arm")});
    const AutoClip made = exaggerated(before, in("Average"));
    REQUIRE(strongest(made).trailId > 0);
    const rig::TrailSettings& settings = findTrail(made.document, strongest(made).trailId)->settings;
    CAPTURE(elbow);
    CHECK(settings.bend == bend);
    const double seconds = settings.endFrame / 30.0;
    const rig::Limb& arm = *findLimb(made.document, "left-arm");
    const auto forearm = [&](const FrameState& state) {
      return rig::endPosition(arm, state) - positionOf(state.worlds[at(arm.joints[1])]);
    };
    const double turned =
        angleBetween(forearm(evaluateOriginal(before, 0, seconds)),
                     forearm(evaluate(made.document, prepareMotion(made.document, 0), seconds)));
    CHECK((turned * 180.0 / pi < 20.1) == (elbow < 1.5));
  }
}

TEST_CASE("A foot stands from where it touches its place until it has left it") {
  const Document before = stepper();
  const ClipGround ground = clipGround(before, 0);
  REQUIRE(ground.standsOf("left-leg").size() == 2);
  const double leaves = ground.standsOf("left-leg").front().y;
  const double comes = ground.standsOf("left-leg").back().x;
  const Vec3 place = ground.pointsOf("left-leg", 0.0).back();
  const auto gone = [&](double frame) {
    return glm::length(ground.pointsOf("left-leg", frame).back() - place) / before.body.height;
  };
  for (const double frame : {leaves, comes}) { // farther than what counts as lowest, and as fast as it goes
                                               // there
    CHECK(gone(frame) > 0.01);
    CHECK(gone(frame) < 0.03);
  }
  CHECK(gone(leaves + 1.0) > 0.02);
  CHECK(gone(comes - 1.0) > 0.02);
}

TEST_CASE(
    "Nothing may go below the floor on which feet stand, but what the clip has below it at that frame") {
  const Document document = test::boxer();
  ClipGround ground{document};
  ground.lowestVertex = -0.2;
  ground.lowestVertices = {0.1, -0.2, 0.05};
  CHECK(ground.leastHeightAt(0.0) == -0.2); // no foot stands: it may go where the clip goes at some time
  ground.floor = 0.0;
  CHECK(ground.leastHeightAt(0.0) == 0.0);
  CHECK(ground.leastHeightAt(1.0) == -0.2);
  CHECK(ground.leastHeightAt(9.0) == 0.0);
  ground.floor = -1.0;
  CHECK(ground.leastHeightAt(2.0) == -0.2);
}

TEST_CASE("A remark on a moment says what it lacks") {
  CHECK(remarkOn(true, false, "").empty());
  CHECK(remarkOn(true, true, "") == "along the ground");
  CHECK(remarkOn(true, false, "the mesh would tear") == "with more the mesh would tear");
  CHECK(remarkOn(true, true, "the mesh would tear") == "along the ground, with more the mesh would tear");
  CHECK(remarkOn(false, false, "the foot carries the body there") == "the foot carries the body there");
}

TEST_CASE("The punch of a clip gets a trail over its moment with the style's scale, and the arm is as long") {
  const Document before = test::boxer();
  const AutoClip made = exaggerated(before, in("Opera"));
  const AutoMoment& punch = strongest(made);
  CHECK(punch.moment.limb == "left-arm");
  REQUIRE(punch.trailId > 0);
  const rig::Trail& trail = *findTrail(made.document, punch.trailId);
  CHECK((trail.exaggerated && trail.connected));
  CHECK(trail.settings.endFrame == punch.moment.endFrame);
  CHECK(punch.scale == trail.settings.scale);
  CHECK(armRatio(made.document, trail.settings.endFrame) == Approx(punch.scale).epsilon(1e-3));
  CHECK(before.trails.empty());
}

TEST_CASE("More strength makes the arm longer, and none leaves the clip as it was") {
  const Document before = test::boxer();
  const double usual = strongest(exaggerated(before, in("Subtle"))).scale;
  const double more = strongest(exaggerated(before, in("Subtle", 2.0))).scale;
  CHECK(usual > 1.0);
  CHECK(more > usual);
  const AutoClip none = exaggerated(before, in("Subtle", 0.0));
  CHECK(sameDocument(none.document, before));
  CHECK(strongest(none).why == "the strength is 0");
}

TEST_CASE("Only the moments that are asked for are exaggerated") {
  const Document before = test::boxer();
  const AutoClip none = exaggerateClip(before, 0, {}, in("Opera"));
  CHECK(none.moments.empty());
  CHECK(sameDocument(none.document, before));
}

TEST_CASE("A trail that is there keeps its limb to itself, and says so") {
  const rig::Moment punch = momentsOf(test::boxer(), 0).front();
  const Document before =
      test::withNewTrail(test::boxer(), {"left-arm", punch.startFrame, punch.endFrame, 1.3});
  const AutoClip made = exaggerated(before, in("Opera"));
  CHECK(strongest(made).trailId == 0);
  CHECK(strongest(made).why == "a trail is there already");
  CHECK(made.document.trails.front() == before.trails.front());
}

TEST_CASE("A limb that the character lacks and a landing of the whole body are left out with a reason") {
  const Document before = test::boxer();
  rig::Moment lacking = momentsOf(before, 0).front();
  rig::Moment landing = lacking;
  lacking.limb = "tail";
  landing.limb = rig::wholeBody;
  landing.kind = rig::MomentKind::landing;
  const AutoClip made = exaggerateClip(before, 0, {lacking, landing}, in("Opera"));
  REQUIRE(made.moments.size() == 2);
  CHECK(made.moments[0].why == "the character has no such limb");
  CHECK_THAT(made.moments[1].why, Catch::Contains("feet stay"));
  CHECK(made.trailIds.empty());
}

TEST_CASE("The spine that goes along with a punch is pulled, and complains of no length") {
  const AutoClip made = exaggerated(test::openedFile(test::posedCharacter), in("Snappy"));
  const rig::MotionState motion = prepareMotion(made.document, 0);
  const auto spine = std::ranges::find_if(
      motion.trails, [](const rig::SolvedTrail& solved) { return solved.limb.id == "spine"; });
  REQUIRE(spine != motion.trails.end());
  CHECK(spine->settings.scale == 1.0);
  CHECK_FALSE(spine->settings.spheres.empty());
  CHECK(spine->warnings.empty());
}

TEST_CASE("A bat stays in the hands that swing it, in each for as long as it holds on in the clip") {
  const Document before = test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb");
  const AutoClip made = exaggerated(before, in("Average"));
  REQUIRE(made.document.holds.props.size() == 1);
  REQUIRE(made.document.holds.props.front().hands.size() == 2);
  CHECK(std::ranges::find(made.notes, "Bat stays in hand") != made.notes.end());
  const auto bat = std::ranges::find(before.scene->nodes, "Bat", &Node::name) - before.scene->nodes.begin();
  const rig::MotionState motion = prepareMotion(made.document, 0);
  double longest = 0.0;
  for (double frame = 30.0; frame <= 60.0; frame += 1.0) {
    const FrameState source = evaluateOriginal(before, 0, frame / 24.0);
    const FrameState now = evaluate(made.document, motion, frame / 24.0);
    const auto fromBat = [&](const FrameState& state, const char* arm) {
      return glm::length(rig::endPosition(*findLimb(before, arm), state) -
                         positionOf(state.worlds[static_cast<std::size_t>(bat)]));
    };
    CAPTURE(frame);
    CHECK(fromBat(now, "left-arm") == Approx(fromBat(source, "left-arm")).margin(0.01));
    if (frame <= 44.0) { // then the right hand lets go
      CHECK(fromBat(now, "right-arm") == Approx(fromBat(source, "right-arm")).margin(0.01));
    }
    longest = std::max(longest, rig::limbLength(*findLimb(before, "left-arm"), now) /
                                    rig::limbLength(*findLimb(before, "left-arm"), source));
  }
  CHECK(longest > 1.5);
  const std::vector<rig::PropHand>& hands = made.document.holds.props.front().hands;
  const auto right = std::ranges::find(hands, "right-arm", &rig::PropHand::limb);
  REQUIRE(right != hands.end());
  CHECK(right->keys.back().frame == Approx(47.0).margin(1.0));
  CHECK(right->keys.back().value == 0.0);
  CHECK(exaggerated(test::boxer(), in("Average")).document.holds.empty());
}

TEST_CASE("Both arms reach with the bat at the same time, and as far") {
  const Document before = test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb");
  const AutoClip made = exaggerated(before, in("Average"));
  const auto trailOf = [&](const std::string& arm) {
    const auto trail = std::ranges::find(made.document.trails, arm, &rig::Trail::limb);
    REQUIRE(trail != made.document.trails.end());
    return trail->settings;
  };
  const rig::TrailSettings right = trailOf("right-arm"), left = trailOf("left-arm");
  CHECK(left.startFrame == right.startFrame);
  CHECK(left.endFrame == right.endFrame);
  CHECK(left.scale == right.scale);
  const double seconds = right.endFrame / 24.0;
  const FrameState source = evaluateOriginal(before, 0, seconds);
  const FrameState now = evaluate(made.document, prepareMotion(made.document, 0), seconds);
  for (const char* const arm : {"right-arm", "left-arm"}) {
    const rig::Limb& limb = *findLimb(before, arm);
    CAPTURE(arm);
    CHECK(rig::limbLength(limb, now) > 1.6 * rig::limbLength(limb, source));
  }
  CHECK(std::ranges::count(made.document.trails, "left-arm", &rig::Trail::limb) == 1);
}

TEST_CASE("A style with weight gives it to arms that have a trail") {
  const AutoClip made = exaggerated(test::boxer(), in("Heavy"));
  REQUIRE_FALSE(made.trailIds.empty());
  const WeightedLimb* const weight = findWeight(made.document, "left-arm", 0);
  REQUIRE(weight != nullptr);
  CHECK(weight->settings.amount == 0.5);
  CHECK(weight->settings.stiffness == 0.8);
  CHECK(findWeight(made.document, "spine", 0) == nullptr);
  CHECK(exaggerated(test::boxer(), in("Opera")).document.weights.empty());
  // No more than all of it, and a limb with weight of its own keeps that.
  AutoSettings strong = in("Subtle", 2.0);
  strong.style.weight = {0.8, 0.3, 0.4};
  Document weighted = exaggerated(test::boxer(), strong).document;
  REQUIRE(findWeight(weighted, "left-arm", 0) != nullptr);
  CHECK(findWeight(weighted, "left-arm", 0)->settings.amount == 1.0);
  CHECK(findWeight(weighted, "left-arm", 0)->settings.damping == 0.4);
  weighted.trails.clear();
  CHECK(findWeight(exaggerated(weighted, in("Heavy")).document, "left-arm", 0)->settings.stiffness == 0.3);
}

TEST_CASE("A style that is taken from a clip gives the same ratios where it is put on again") {
  const Document first = exaggerated(test::boxer(), in("Opera")).document;
  const Result<rig::Style> taken = styleOfClip(first, 0, "Taken");
  REQUIRE(taken.ok());
  const AutoClip again = exaggerateClip(test::boxer(), 0, momentsOf(test::boxer(), 0), {*taken, 1.0});
  const double tip = strongest(again).moment.endFrame;
  CHECK(armRatio(again.document, tip) == Approx(armRatio(first, tip)).epsilon(0.02));
}

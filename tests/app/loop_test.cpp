#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/ranges.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/way_back.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;
using Catch::Matchers::Contains;

namespace {

/// The boxer with a clip that ends as it begins.
Document shadowBoxer() {
  Document document = test::boxer();
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.front().edit(
      [](Track& turn) { std::copy(turn.values.begin(), turn.values.begin() + 4, turn.values.end() - 4); });
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  return document;
}

Document withTrailTo(const Document& document, double startFrame, double endFrame) {
  return test::withNewTrail(document, {.startFrame = startFrame, .endFrame = endFrame, .scale = 3.0});
}

std::optional<WayBackProblem> problemOf(const Document& document) {
  const rig::MotionState motion = prepareMotion(document, 0);
  return wayBackProblem(document, motion, motion.trails.front());
}

Result<ExaggerateTargets> exaggeratedOver(Session& session, double start, double end) {
  session.view().selection.editTrails().limbs = {"left-arm"};
  session.view().rangeStart = start;
  session.view().rangeEnd = end;
  return exaggerateTargets(session);
}

} // namespace

TEST_CASE("A clip whose last pose is its first can loop, however far the body got, another one cannot") {
  CHECK(endsMeet(shadowBoxer(), 0));
  CHECK_FALSE(endsMeet(test::boxer(), 0));
}

TEST_CASE(
    "A stretch that ends at the seam of a clip that could loop is told, and marking the loop mends it") {
  const Document cut = withTrailTo(shadowBoxer(), 10.0, 20.0);
  const auto problem = problemOf(cut);
  REQUIRE(problem);
  CHECK(problem->loopHelps);
  CHECK_THAT(problem->what, Contains("last pose is its first") && Contains("at the seam"));
  const Document looped = setLooping(cut, 0, true);
  CHECK_FALSE(problemOf(looped));
  const rig::MotionState motion = prepareMotion(looped, 0);
  CHECK(motion.trails.front().release.seconds() > 0.0);
}

TEST_CASE(
    "On a loop nothing jumps at the seam, whichever end of the range is the pivot and whichever lies there") {
  constexpr double seconds = 20.0 / 30.0;
  constexpr double moment = 1e-4;
  for (const rig::Pivot pivot : {rig::Pivot::start, rig::Pivot::end}) {
    for (const Vec2& range : {Vec2(0.0, 8.0), Vec2(12.0, 20.0), Vec2(2.0, 8.0), Vec2(12.0, 18.0)}) {
      CAPTURE(static_cast<int>(pivot), range.x, range.y);
      Document document = setLooping(withTrailTo(shadowBoxer(), range.x, range.y), 0, true);
      document.trails.front().settings.pivot = pivot;
      document.trails.front().settings.releaseFrames = 4.0;
      const rig::MotionState motion = prepareMotion(document, 0);
      const rig::Limb& arm = *findLimb(document, "left-arm");
      const auto handAt = [&](double time) {
        return rig::endPosition(arm, evaluate(document, motion, time));
      };
      CHECK(glm::distance(handAt(0.0), handAt(moment)) < 0.01);
      CHECK(glm::distance(handAt(seconds), handAt(seconds - moment)) < 0.01);
      CHECK(glm::distance(handAt(0.0), handAt(seconds)) < 1e-3);
      const double tip = (pivot == rig::Pivot::start ? range.y : range.x) / 30.0;
      CHECK(glm::distance(handAt(tip), rig::endPosition(arm, evaluateOriginal(document, 0, tip))) > 0.1);
    }
  }
}

TEST_CASE("A way back that is cut because its range begins again on a loop is told") {
  const Document looped = setLooping(withTrailTo(shadowBoxer(), 1.0, 20.0), 0, true);
  const auto problem = problemOf(looped);
  REQUIRE(problem);
  CHECK_FALSE(problem->loopHelps);
  CHECK_THAT(problem->what, Contains("snaps back in 1 frame") && Contains("make the range shorter"));
}

TEST_CASE("A way back that the clip's end cuts short is told, a stretch that lasts to the end is held") {
  const auto problem = problemOf(withTrailTo(test::boxer(), 5.0, 19.5));
  REQUIRE(problem);
  CHECK_FALSE(problem->loopHelps);
  CHECK_THAT(problem->what, Contains("snaps back") && Contains("end the range earlier"));
  CHECK_FALSE(problemOf(withTrailTo(test::boxer(), 5.0, 20.0)));
  CHECK_FALSE(problemOf(withTrailTo(test::boxer(), 0.0, 10.0)));
}

TEST_CASE("The first trail that needs it marks a clip whose ends meet as a loop, in the same step") {
  Session session(shadowBoxer());
  const auto early = exaggeratedOver(session, 0.0, 10.0);
  REQUIRE(early);
  CHECK_FALSE(early->madeLoop);
  const auto late = exaggeratedOver(session, 10.0, 20.0);
  REQUIRE(late);
  CHECK(late->madeLoop);
  REQUIRE(session.edit(late->document, "Exaggerate"));
  CHECK(isLooping(session.document(), 0));
  session.undo();
  CHECK_FALSE(isLooping(session.document(), 0));
  CHECK(session.document().trails.empty());
}

TEST_CASE("Going on to another stroke leaves the loop that was marked, as it was told") {
  Session session(shadowBoxer());
  const auto late = exaggeratedOver(session, 10.0, 20.0);
  REQUIRE(late);
  const Result<ExaggerateTargets> early = movedTo(session, *late, {0.0, 10.0});
  REQUIRE(early);
  CHECK(isLooping(early->document, 0));
  CHECK(early->madeLoop);
}

TEST_CASE("A stroke that is gone on to marks the loop that it needs, at the scale that was chosen") {
  Session session(shadowBoxer());
  const auto early = exaggeratedOver(session, 0.0, 10.0);
  REQUIRE(early);
  ExaggerateTargets targets = *early;
  findTrail(targets.document, targets.trailIds.front())->settings.scale = 3.5;
  const Result<ExaggerateTargets> late = movedTo(session, targets, {10.0, 20.0});
  REQUIRE(late);
  CHECK(late->madeLoop);
  CHECK(isLooping(late->document, 0));
  CHECK(findTrail(late->document, late->trailIds.front())->settings.scale == 3.5);
}

TEST_CASE("Weight that is on, a loop that is one, and trails of the clip itself leave the clip as it is") {
  Document document = shadowBoxer();
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>(2, document.clips->front()));
  const auto marks = [](const Document& of) {
    Session session(of);
    const auto late = exaggeratedOver(session, 10.0, 20.0);
    REQUIRE(late);
    return late->madeLoop;
  };
  CHECK(marks(document));
  CHECK_FALSE(marks(setLooping(document, 0, true)));
  CHECK(marks(setLooping(document, 1, true)));
  for (const auto& [clip, on] : {std::pair(0, true), std::pair(0, false), std::pair(1, true)}) {
    CAPTURE(clip, on);
    Document heavy = document;
    heavy.weights = {{"right-arm", clip, on, {}}};
    CHECK(marks(heavy) == (clip != 0 || !on));
  }
  Document other = withTrailTo(document, 0.0, 5.0);
  other.trails.front().clip = 1;
  CHECK(marks(other));
}

TEST_CASE("What was decided about the loop is not decided again, and other clips are left alone") {
  Session decided(withTrailTo(shadowBoxer(), 0.0, 5.0));
  const auto second = exaggeratedOver(decided, 10.0, 20.0);
  REQUIRE(second);
  CHECK_FALSE(second->madeLoop);
  Session open(test::boxer());
  const auto held = exaggeratedOver(open, 10.0, 20.0);
  REQUIRE(held);
  CHECK_FALSE(held->madeLoop);
}

TEST_CASE("The strokes of a limb are gone through, round and round, by trails that were made just now") {
  Session session(test::boxer());
  session.view().selection.editTrails().limbs = {"left-arm"};
  const Result<ExaggerateTargets> made = exaggerateTargets(session);
  REQUIRE(made);
  CHECK(findTrail(made->document, made->trailIds.front())->settings.endFrame == 10.0); // The stronger one.
  const std::optional<Vec2> back = nextStroke(session, *made, true);
  REQUIRE(back);
  CHECK(*back == Vec2(10.0, 20.0));
  const Result<ExaggerateTargets> moved = movedTo(session, *made, *back);
  REQUIRE(moved);
  CHECK(findTrail(moved->document, moved->trailIds.front())->settings.startFrame == 10.0);
  CHECK(nextStroke(session, *moved, true) == std::optional(Vec2(0.0, 10.0)));
  CHECK(nextStroke(session, *moved, false) == std::optional(Vec2(0.0, 10.0)));
  session.edit(made->document, "Exaggerate");
  CHECK_FALSE(nextStroke(session, *made, true)); // That trail may have been worked on.
}

TEST_CASE(
    "The path of a limb is drawn over the seam of a loop that stays where it is, of one that travels not") {
  const auto [way, crosses] =
      GENERATE(table<double, bool>({{0.0, true}, {0.08, true}, {0.12, false}, {2.0, false}})); // 1.8 high
  Document document = shadowBoxer();
  std::vector<Clip> clips = *document.clips;
  Track track;
  track.node = document.body.hips;
  track.channel = Channel::translation;
  track.width = 3;
  track.times = {0.0F, static_cast<float>(clips.front().endSeconds)};
  track.values = {0.0F, 1.0F, 0.0F, 0.0F, 1.0F, static_cast<float>(way)};
  clips.front().tracks.emplace_back(std::move(track));
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  document = setLooping(withTrailTo(document, 10.0, 20.0), 0, true);
  const rig::MotionState motion = prepareMotion(document, 0);
  REQUIRE(motion.trails.front().release.seconds() > 0.0);
  CHECK((trailPaths(document, motion, 1).front().drawn.frames.back() > 20.5) == crosses);
}

TEST_CASE(
    "On a loop that stays where it is the blend of a hold goes on across the seam, on others it does not") {
  rig::Pin pin;
  pin.limb = "left-arm";
  pin.time = {{0.0, 3.0}, {4.0, 0.0}};
  pin.atFrame = 3.0;
  rig::Holds wanted;
  wanted.pins.push_back(pin);
  const Result<Document> held = placeHolds(shadowBoxer(), wanted);
  REQUIRE(held);
  const double last = clipOf(*held, 0).endSeconds;
  const auto strength = [&](const Document& document, double framesBefore) {
    const rig::MotionState motion = prepareMotion(document, 0);
    return motion.holds.pins.front()->span.strengthAt(last - framesBefore / motion.framesPerSecond);
  };
  CHECK(strength(*held, 1.0) == 0.0);
  const Document looped = setLooping(*held, 0, true);
  CHECK(strength(looped, 0.0) == 1.0);
  CHECK(strength(looped, 2.0) == Approx(0.5));
  CHECK(strength(looped, 4.5) == 0.0);
  const auto endAt = [&](double seconds) {
    return rig::endPosition(*findLimb(looped, "left-arm"),
                            evaluate(looped, prepareMotion(looped, 0), seconds));
  };
  CHECK(glm::length(endAt(last) - endAt(0.0)) < 1e-9);
}

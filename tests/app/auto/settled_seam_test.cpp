// What a trail near the seam of a loop becomes, so that the loop closes as it did.
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/auto/planned_trail.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The settings of one trail of the left arm in a loop of 24 frames once that is settled; nothing where it
/// was left out. `holds`: those that were there before.
std::optional<rig::TrailSettings> settled(const rig::TrailSettings& wanted, bool wraps = true,
                                          const rig::Holds& holds = {}) {
  Document document = test::swinger();
  document.holds = holds;
  ClipGround ground = clipGround(document, 0);
  ground.wraps = wraps;
  PlannedTrail planned;
  planned.trail.limb = "left-arm";
  planned.trail.exaggerated = planned.trail.connected = true;
  planned.trail.settings = wanted;
  AutoPlan plan;
  plan.trails = {planned};
  plan.leftOut.resize(1);
  plan.loops = wraps;
  const rig::Moment moment{"left-arm",      rig::MomentKind::stroke, wanted.startFrame,
                           wanted.endFrame, wanted.endFrame,         9.0};
  settle(ground, {moment}, test::in("Rubber hose"), plan);
  return plan.trails.empty() ? std::nullopt : std::optional(plan.trails[0].trail.settings);
}

rig::TrailSettings over(double startFrame, double endFrame, double release, double linger = 0.0) {
  rig::TrailSettings settings;
  settings.startFrame = startFrame;
  settings.endFrame = endFrame;
  settings.releaseFrames = release;
  settings.lingerFrames = linger;
  settings.scale = 1.3;
  return settings;
}

} // namespace

TEST_CASE("A trail over a loop's first frame starts a frame later, where two frames are left of it") {
  const bool wraps = GENERATE(true, false);
  const auto startOf = [&](double startFrame, double endFrame) {
    const std::optional<rig::TrailSettings> now = settled(over(startFrame, endFrame, 5.0), wraps);
    REQUIRE(now);
    CHECK(now->endFrame == endFrame);
    CHECK(now->releaseFrames == 5.0);
    return now->startFrame;
  };
  CHECK(startOf(0.0, 3.0) == 1.0);
  CHECK(startOf(0.0, 2.0) == 0.0); // There is less of it instead.
  CHECK(settled(over(0.0, 3.0, 5.0), wraps)->scale == 1.3);
  CHECK(settled(over(0.0, 2.0, 5.0), wraps)->scale < 1.2);
  CHECK(startOf(0.0, 7.0) == 0.0); // So long a one begins too slowly to be seen.
}

TEST_CASE("A way back that opens a loop's seam ends a frame before it, where it has three frames") {
  const auto [end, release, left] = GENERATE(table<double, double, double>(
      {{18.0, 6.0, 5.0}, {19.0, 5.0, 4.0}, {20.0, 4.0, 3.0}, {18.0, 4.0, 4.0}, {16.0, 6.0, 6.0}}));
  const bool wraps = GENERATE(true, false);
  CAPTURE(end, release, wraps);
  rig::TrailSettings swinging = over(8.0, end, release);
  swinging.overshoot = 0.5; // It is past its place where it ends on the seam.
  const std::optional<rig::TrailSettings> now = settled(swinging, wraps);
  REQUIRE(now);
  CHECK(now->releaseFrames == left);
  CHECK(now->startFrame == 8.0);
  CHECK(now->endFrame == end);
  CHECK(now->lingerFrames == 0.0);
  CHECK(now->scale == 1.3);
}

TEST_CASE("A pose that is held by a loop's end is let go of at once before its way back gets shorter") {
  rig::TrailSettings held = over(8.0, 18.0, 6.0, 3.0);
  held.overshoot = 0.5;
  const std::optional<rig::TrailSettings> now = settled(held);
  REQUIRE(now);
  CHECK(now->lingerFrames == 0.0);
  CHECK(now->releaseFrames == 3.0);
  CHECK(now->endFrame == 18.0);
}

TEST_CASE("A pose that was to be held over a loop's seam leaves three frames to come back before it") {
  const auto [end, release, held, left, leftHeld] =
      GENERATE(table<double, double, double, double, double>({{20.0, 4.5, 4.2, 3.0, 0.0},
                                                              {19.0, 5.4, 5.1, 4.0, 1.0},
                                                              {18.0, 6.4, 6.1, 5.0, 2.0},
                                                              {14.0, 10.4, 10.1, 9.0, 6.0}}));
  const std::optional<rig::TrailSettings> now = settled(over(8.0, end, release, held));
  REQUIRE(now);
  CHECK(now->endFrame == end);
  CHECK(now->releaseFrames == left);
  CHECK(now->lingerFrames == leftHeld);
  CHECK(now->scale == 1.3);
}

TEST_CASE("What is struck at a loop's seam is held until a frame after it, and comes back there as late") {
  struct Struck {
    double end, release, endsAt, held, back;
  };
  const Struck struck = GENERATE(Struck{22.0, 5.0, 22.0, 3.0, 6.0}, Struck{23.0, 5.0, 23.0, 2.0, 5.0},
                                 Struck{24.0, 5.0, 23.0, 2.0, 6.0}, Struck{24.0, 9.0, 23.0, 2.0, 10.0},
                                 Struck{24.0, 4.0, 23.0, 2.0, 5.0});
  CAPTURE(struck.end, struck.release);
  const std::optional<rig::TrailSettings> now = settled(over(12.0, struck.end, struck.release));
  REQUIRE(now);
  CHECK(now->startFrame == 12.0);
  CHECK(now->endFrame == struck.endsAt);
  CHECK(now->lingerFrames == Approx(struck.held).margin(1e-5)); // Keys are of single precision.
  CHECK(*now->releaseFrames == Approx(struck.back).margin(1e-5));
  CHECK(now->scale == 1.3);
}

TEST_CASE("Where a way back cannot go on at a loop's start there is less of what is struck before its seam") {
  const std::optional<rig::TrailSettings> now = settled(over(12.0, 22.0, 5.0), false);
  REQUIRE(now);
  CHECK(now->endFrame == 22.0);
  CHECK(now->lingerFrames == 0.0);
  CHECK(now->releaseFrames == 5.0);
  CHECK(now->scale < 1.2);
  CHECK_FALSE(settled(over(12.0, 23.0, 5.0), false)); // It has no room at all.
}

TEST_CASE("A trail whose limb is farthest before its end ends there, and is back when it would have been") {
  struct Ended {
    double start, end, held, back, heldSince;
  };
  const Ended ended = GENERATE(Ended{2.0, 16.0, 0.0, 13.0, 0.0}, Ended{2.0, 16.0, 2.0, 13.0, 11.0},
                               Ended{4.0, 14.0, 0.0, 11.0, 0.0}, Ended{4.0, 14.0, 2.0, 11.0, 9.0});
  CAPTURE(ended.start, ended.end, ended.held);
  const std::optional<rig::TrailSettings> now = settled(over(ended.start, ended.end, 4.0, ended.held), false);
  REQUIRE(now);
  CHECK(now->startFrame == ended.start);
  CHECK(now->endFrame == 7.0); // The arm strikes until then.
  CHECK(*now->releaseFrames == Approx(ended.back).margin(1e-6));
  CHECK(now->lingerFrames == Approx(ended.heldSince).margin(1e-6));
}

TEST_CASE("Of what is more than a path allows there is less, and less of it is not held") {
  const auto [start, end, held] = GENERATE(
      table<double, double, double>({{2.0, 14.0, 2.0}, {2.0, 7.0, 1.0}, {8.0, 18.0, 3.0}, {8.0, 14.0, 0.0}}));
  rig::TrailSettings wanted = over(start, end, 5.0, held);
  wanted.scale = 6.0; // No path is drawn out to more than half as much again as the largest scale.
  const std::optional<rig::TrailSettings> now = settled(wanted, false);
  REQUIRE(now);
  CHECK(now->scale == Approx(4.5));
  CHECK(now->lingerFrames == 0.0);
  CHECK(*now->releaseFrames == 5.0 - held);
  CHECK(now->endFrame == end);
}

TEST_CASE("A trail is looked at as if nothing held its limb") {
  rig::Pin pin;
  pin.limb = GENERATE("left-arm", "right-arm");
  pin.time = {{0.0, 24.0}, {0.0, 0.0}};
  const std::optional<rig::TrailSettings> now = settled(over(2.0, 7.0, 5.0), false, {{pin}, {}, {}});
  REQUIRE(now);
  CHECK(*now == *settled(over(2.0, 7.0, 5.0), false));
}

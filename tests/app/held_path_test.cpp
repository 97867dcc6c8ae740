#include <algorithm>
#include <tuple>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/pose/hold_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr std::size_t samplesPerFrame = 2;

Document pinnedPunch(bool connected) {
  const Document document = test::withNewTrail(test::boxer(), {.connected = connected});
  rig::Holds holds;
  holds.pins.resize(1);
  holds.pins[0].limb = "left-arm";
  holds.pins[0].atFrame = 2.0;
  holds.pins[0].time = {{4.0, 7.0}, {1.0, 2.0}};
  const Result<Document> held = placeHolds(document, holds);
  REQUIRE(held);
  return *held;
}

} // namespace

TEST_CASE("the path of a limb is drawn where its holds leave it") {
  const Document document = pinnedPunch(true);
  const rig::MotionState motion = prepareMotion(document, 0);
  EvaluationCache cache;
  const TrailPaths& paths = cache.paths(document, 0, samplesPerFrame).front();
  const rig::Limb& arm = *findLimb(document, "left-arm");
  for (const rig::DrawnTrail* drawn : {&paths.drawn, &paths.spheres}) {
    REQUIRE_FALSE(drawn->frames.empty());
    for (std::size_t i = 0; i < drawn->frames.size(); ++i) {
      const FrameState seen = evaluate(document, motion, drawn->frames[i] / motion.framesPerSecond);
      CHECK(glm::length(drawn->exaggerated[i] - rig::endPosition(arm, seen)) < 1e-9);
    }
  }
}

TEST_CASE("the path of a trail that is not connected shows what it would be, and the original path stays") {
  const Document document = pinnedPunch(false);
  Document unheld = document;
  unheld.holds = {};
  EvaluationCache cache;
  const rig::DrawnTrail held = cache.paths(document, 0, samplesPerFrame).front().drawn;
  const rig::DrawnTrail free = cache.paths(unheld, 0, samplesPerFrame).front().drawn;
  CHECK(held == free);
  CHECK(cache.paths(pinnedPunch(true), 0, samplesPerFrame).front().drawn.original == free.original);
}

TEST_CASE("the drawn path follows a hold that is moved, and is the trail's again without it") {
  Document document = pinnedPunch(true);
  EvaluationCache cache;
  const rig::DrawnTrail before = cache.paths(document, 0, samplesPerFrame).front().drawn;
  document.holds.pins[0].time.rangeFrames = {2.0, 5.0};
  const rig::DrawnTrail moved = cache.paths(document, 0, samplesPerFrame).front().drawn;
  CHECK_FALSE(moved == before);
  document.holds = {};
  const rig::DrawnTrail free = cache.paths(document, 0, samplesPerFrame).front().drawn;
  CHECK(free == trailPaths(document, prepareMotion(document, 0), samplesPerFrame).front().drawn);
}

TEST_CASE(
    "a pinned arm gives back the thickness that its trail at that time made, whatever trails come later") {
  Document document = test::boxer();
  for (const auto& [first, last, volume] : {std::tuple(2.0, 6.0, 1.0), std::tuple(12.0, 16.0, 0.0)}) {
    NewTrail wanted;
    wanted.limb = "left-arm";
    wanted.settings.startFrame = first;
    wanted.settings.endFrame = last;
    wanted.settings.scale = 2.0;
    wanted.settings.volume = volume;
    wanted.settings.releaseFrames = 2.0;
    wanted.connected = true;
    const Result<CreatedTrail> created = createTrail(document, wanted);
    REQUIRE(created);
    document = created->document;
  }
  for (const double frame : {5.0, 6.0, 7.0, 15.0, 16.0}) {
    CAPTURE(frame);
    rig::Holds holds;
    holds.pins.resize(1);
    holds.pins[0].limb = "left-arm";
    holds.pins[0].atFrame = frame;
    holds.pins[0].time = {{frame, frame}, {0.0, 0.0}};
    const Result<Document> held = placeHolds(document, holds);
    REQUIRE(held);
    const rig::Limb& arm = *findLimb(document, "left-arm");
    const auto farthestFromRound = [&](const Document& shown) {
      const FrameState seen = evaluate(shown, prepareMotion(shown, 0), frame / 30.0);
      double farthest = 0.0;
      for (const NodeIndex joint : arm.joints) {
        for (int column = 0; column < 3 && !seen.stretch.empty(); ++column) {
          farthest = std::max(farthest, glm::length(seen.stretch[at(joint)][column] - Mat3(1.0)[column]));
        }
      }
      return farthest;
    };
    CHECK(farthestFromRound(document) > 0.1);
    CHECK(farthestFromRound(*held) < 1e-6);
  }
}

#include "app/auto/loop_seam.h"

#include <cmath>
#include <memory>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double metre = 2.0; // World units of a metre of a person.

Document largeBoxer() {
  Document document = test::boxer();
  document.body.size = metre * characterSizeMetres;
  return document;
}

ClipGround groundAt(const Document& document, double framesPerSecond) {
  ClipGround ground{document, 0};
  ground.framesPerSecond = framesPerSecond;
  return ground;
}

/// Two limbs of three points that stand still.
LoopSeam standingSeam() {
  const LimbPlaces places(2, std::vector<Vec3>{Vec3(1.0), Vec3(2.0), Vec3(3.0)});
  return {places, places, places, places};
}

const Vec3 away(0.6, 0.0, -0.8); // Of unit length.

/// A point of the second limb is so far from its place in the last pose, and moves on there as it did.
LoopSeam withGap(LoopSeam seam, double distance, std::size_t point = 1) {
  seam.last[1][point] += distance * away;
  seam.beforeLast[1][point] += distance * away;
  return seam;
}

/// The limb's speed changes by so much from the last pose to the first.
LoopSeam withTurn(LoopSeam seam, double speed, double seconds, std::size_t point = 1) {
  seam.afterFirst[1][point] += speed * seconds * away;
  return seam;
}

double largestDifference(const LimbPlaces& a, const LimbPlaces& b) {
  double largest = 0.0;
  REQUIRE(a.size() == b.size());
  for (std::size_t limb = 0; limb < a.size(); ++limb) {
    REQUIRE(a[limb].size() == b[limb].size());
    for (std::size_t k = 0; k < a[limb].size(); ++k) {
      largest = std::max(largest, glm::length(a[limb][k] - b[limb][k]));
    }
  }
  return largest;
}

} // namespace

TEST_CASE("A seam closes worse where a limb is more than 8 mm farther from its first place than it was") {
  const Document document = largeBoxer();
  const ClipGround ground = groundAt(document, 30.0);
  const std::size_t point = GENERATE(0U, 1U, 2U);
  const double own = GENERATE(0.0, 0.5); // Gap of the source.
  const LoopSeam source = withGap(standingSeam(), own, point);
  const auto worse = [&](double gap, std::size_t limb) {
    return closesWorse(ground, withGap(standingSeam(), gap, point), source, limb);
  };
  CHECK_FALSE(worse(own, 1));
  CHECK_FALSE(worse(own + 0.0079 * metre, 1));
  CHECK(worse(own + 0.0081 * metre, 1));
  CHECK_FALSE(worse(own + 1.0, 0)); // The other limb closes as it did.
  CHECK_FALSE(worse(0.0, 1));       // Nor is closing better worse.
}

TEST_CASE("A seam closes worse where a limb turns more sharply by more than 0.04 m/s") {
  const auto [rate, seconds] = GENERATE(table<double, double>(
      {{10.0, 1.0 / 40.0}, {24.0, 1.0 / 96.0}, {30.0, 1.0 / 120.0}, {60.0, 1.0 / 120.0}}));
  const double own = GENERATE(0.0, 3.0);
  const std::size_t point = GENERATE(0U, 2U);
  CAPTURE(rate, own);
  const Document document = largeBoxer();
  const ClipGround ground = groundAt(document, rate);
  const double length = seconds;
  const LoopSeam source = withTurn(standingSeam(), own, length, point);
  const auto worse = [&](double speed, std::size_t limb) {
    return closesWorse(ground, withTurn(standingSeam(), speed, length, point), source, limb);
  };
  CHECK_FALSE(worse(own, 1));
  CHECK_FALSE(worse(own + 0.039 * metre, 1));
  CHECK(worse(own + 0.041 * metre, 1));
  CHECK_FALSE(worse(own + 9.0, 0));
}

TEST_CASE("A limb that goes on across the seam as fast as it comes to it does not turn there") {
  const Document document = largeBoxer();
  const ClipGround ground = groundAt(document, 30.0);
  const auto moving = [](double before, double after) {
    LoopSeam seam = standingSeam();
    seam.beforeLast[1][0] -= before * away;
    seam.afterFirst[1][0] += after * away;
    return seam;
  };
  CHECK_FALSE(closesWorse(ground, moving(0.4, 0.4), standingSeam(), 1));
  CHECK(closesWorse(ground, moving(0.4, -0.4), standingSeam(), 1));
  CHECK(closesWorse(ground, moving(0.4, 0.0), standingSeam(), 1));
  CHECK(closesWorse(ground, moving(0.0, 0.4), standingSeam(), 1));
}

TEST_CASE(
    "A seam is seen at both ends of a clip and a quarter of a frame inside, or as a 120th of a second") {
  const double rate = GENERATE(10.0, 30.0, 60.0);
  const double firstFrame = GENERATE(0.0, 3.0, -2.0);
  Document document = test::swinger();
  Clip clip = document.clips->front();
  clip.framesPerSecond = rate;
  clip.startSeconds = firstFrame / 30.0;
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  document.trails = {};
  ClipGround ground = groundAt(document, rate);
  ground.limbs = allLimbs(document);
  Document moved = document;
  moved.trails.emplace_back();
  moved.trails[0].id = 1;
  moved.trails[0].limb = "left-arm";
  moved.trails[0].exaggerated = moved.trails[0].connected = true;
  moved.trails[0].settings.endFrame = 0.3 * rate;
  moved.trails[0].settings.scale = 1.5;
  const rig::MotionState motion = prepareMotion(moved, 0);
  const LoopSeam source = seamOfSource(ground);
  const LoopSeam now = seamOf(ground, moved, motion);
  const double step = rate < 30.0 ? 0.25 / rate : 1.0 / 120.0;
  const double start = std::min(0.0, firstFrame / 30.0);
  const double end = clip.endSeconds;
  const auto check = [&](const LimbPlaces& ofSource, const LimbPlaces& ofNow, double seconds) {
    CAPTURE(seconds);
    CHECK(largestDifference(ofSource, placesOf(ground.limbs, evaluateOriginal(document, 0, seconds))) <
          1e-12);
    CHECK(largestDifference(ofNow, placesOf(ground.limbs, evaluate(moved, motion, seconds))) < 1e-12);
  };
  check(source.first, now.first, start);
  check(source.afterFirst, now.afterFirst, start + step);
  check(source.beforeLast, now.beforeLast, end - step);
  check(source.last, now.last, end);
}

#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

bool isWhole(float timeSeconds, double framesPerSecond) {
  const double frame = static_cast<double>(timeSeconds) * framesPerSecond;
  return std::abs(frame - std::round(frame)) < 1e-3;
}

/// Keys of all tracks and stretches that stand between whole frames.
int keysBetween(const Rekeyed& rekeyed) {
  int count = 0;
  const double rate = rekeyed.motion.framesPerSecond;
  for (const Track& track : rekeyed.keys.tracks) {
    for (const float time : track.times) {
      count += isWhole(time, rate) ? 0 : 1;
    }
  }
  for (const StretchKeys& stretch : rekeyed.keys.stretches) {
    for (const float time : stretch.times) {
      count += isWhole(time, rate) ? 0 : 1;
    }
  }
  return count;
}

void pushSecondKey(CopyOnWrite<Track>& track, double frames) {
  track.edit([&](Track& changed) { changed.times[1] += static_cast<float>(frames / 24.0); });
}

} // namespace

TEST_CASE("keys on whole frames alone are right there, and what they miss between is told") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Trail> trails{connectedTrail("left-arm", 4, 14, 3.0),
                                  connectedTrail("left-leg", 6, 12, 1.5)};
  const Rekeyed needed = rekeyedOf(moving, trails);
  const Rekeyed whole = rekeyedOf(moving, trails, {.places = KeyPlaces::wholeFrames});
  REQUIRE(keysBetween(needed) > 0);
  CHECK(keysBetween(whole) == 0);
  CHECK(needed.keys.largestMiss == 0.0);
  const double tolerance = 0.5e-4 * moving.body.height;
  CHECK(whole.keys.largestMiss > tolerance);
  double atFrames = 0.0;
  double atHalves = 0.0;
  for (int half = 0; half <= 48; ++half) {
    const double frame = 0.5 * half;
    const double miss =
        largestNodeMiss(poseOf(moving, whole.clip, frame), atFrame(moving, whole.motion, frame));
    (half % 2 == 0 ? atFrames : atHalves) = std::max(half % 2 == 0 ? atFrames : atHalves, miss);
  }
  CHECK(atFrames <= tolerance);
  CHECK(atHalves > tolerance);
  CHECK(atHalves <= 1.2 * whole.keys.largestMiss);
}

TEST_CASE("a clip that is keyed between whole frames keeps its own keys") {
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    pushSecondKey(track, 0.4);
  }
  const Rekeyed whole =
      rekeyedOf(moving, {connectedTrail("left-arm", 2, 14, 2.0)}, {.places = KeyPlaces::wholeFrames});
  CHECK(keysBetween(whole) >= 1);
}

TEST_CASE("keys that stand as the clip's do are on whole frames alone where every key of the clip is") {
  const std::vector<Trail> trails{connectedTrail("left-arm", 4, 14, 3.0)};
  MovingBiped moving = punchingBiped();
  const auto keyed = [&](KeyPlaces places) { return rekeyedOf(moving, trails, {.places = places}).keys; };
  CHECK(keyed(KeyPlaces::asClip).tracks == keyed(KeyPlaces::wholeFrames).tracks);
  CHECK(keyed(KeyPlaces::asClip).largestMiss == keyed(KeyPlaces::wholeFrames).largestMiss);
  REQUIRE(keyed(KeyPlaces::wholeFrames).tracks != keyed(KeyPlaces::needed).tracks);

  // One key of one track is enough to say that the clip's maker keys between frames.
  pushSecondKey(moving.clip.tracks.back(), 0.25);
  CHECK(keyed(KeyPlaces::asClip).tracks == keyed(KeyPlaces::needed).tracks);
  CHECK(keyed(KeyPlaces::asClip).largestMiss == 0.0);

  // Single precision is no key between frames.
  pushSecondKey(moving.clip.tracks.back(), -0.2495);
  CHECK(keyed(KeyPlaces::asClip).tracks == keyed(KeyPlaces::wholeFrames).tracks);
}

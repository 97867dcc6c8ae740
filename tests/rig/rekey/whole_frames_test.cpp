#include <algorithm>
#include <cmath>
#include <vector>

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

/// The same keys on a cubic spline that swings wide between them, so that a piece of it is no cubic any more.
void makeCubic(Track& track) {
  const std::size_t width = track.values.size() / track.times.size();
  std::vector<float> values;
  for (std::size_t key = 0; key < track.times.size(); ++key) {
    const std::size_t next = std::min(key + 1, track.times.size() - 1);
    const std::size_t previous = key == 0 ? 0 : key - 1;
    const float span = std::max(track.times[next] - track.times[previous], 1e-3F);
    std::vector<float> slopes;
    for (std::size_t i = 0; i < width; ++i) {
      const float change = track.values[next * width + i] - track.values[previous * width + i];
      slopes.push_back(2.5F * change / span + 0.2F);
    }
    values.insert(values.end(), slopes.begin(), slopes.end());
    for (std::size_t i = 0; i < width; ++i) {
      values.push_back(track.values[key * width + i]);
    }
    values.insert(values.end(), slopes.begin(), slopes.end());
  }
  track.values = std::move(values);
  track.interpolation = Interpolation::cubicSpline;
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

TEST_CASE("what is left of a turning cubic span beside a window is keyed on whole frames too") {
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    track.edit([](Track& changed) {
      if (changed.channel == Channel::rotation) {
        makeCubic(changed);
      }
    });
  }
  const auto trail = GENERATE(connectedTrail("left-arm", 4, 14, 3.0), connectedTrail("left-arm", 3, 7, 1.5),
                              connectedTrail("left-leg", 9, 13, 2.0));
  const Rekeyed needed = rekeyedOf(moving, {trail});
  const Rekeyed whole = rekeyedOf(moving, {trail}, {.places = KeyPlaces::wholeFrames});
  REQUIRE(keysBetween(needed) > 0);
  CHECK(keysBetween(whole) == 0);
  for (int frame = 0; frame <= 24; ++frame) {
    CAPTURE(frame);
    CHECK(largestNodeMiss(poseOf(moving, whole.clip, frame), atFrame(moving, whole.motion, frame)) <=
          0.5e-4 * moving.body.height);
  }
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

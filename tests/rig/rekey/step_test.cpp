#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

MovingBiped withStepOn(const std::string& key,
                       const std::vector<std::pair<double, double>>& degreesAtFrames) {
  MovingBiped moving = punchingBiped();
  const NodeIndex node = moving.node.at(key);
  std::erase_if(moving.clip.tracks, [&](const CopyOnWrite<Track>& track) { return track->node == node; });
  RotationKeys keys;
  for (const auto& [frame, degrees] : degreesAtFrames) {
    keys.emplace_back(frame / 24.0, axisAngle(Vec3(0, 1, 0), -degrees * pi / 180.0));
  }
  moving.clip.tracks.emplace_back(rotationTrack(node, Interpolation::step, keys));
  return moving;
}

const Track& rekeyedTrack(const Rekeyed& rekeyed, NodeIndex node, Channel channel) {
  const auto found = std::ranges::find_if(
      rekeyed.keys.tracks, [&](const Track& t) { return t.node == node && t.channel == channel; });
  REQUIRE(found != rekeyed.keys.tracks.end());
  return *found;
}

} // namespace

TEST_CASE("a STEP track that is constant becomes LINEAR and holds its value outside") {
  const MovingBiped moving = withStepOn("foreArm.l", {{0, 40}, {24, 40}});
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.bend = Bend::straighten;
  const Rekeyed rekeyed = rekeyedOf(moving, {trail});
  CHECK(rekeyedTrack(rekeyed, moving.node.at("foreArm.l"), Channel::rotation).interpolation ==
        Interpolation::linear);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("a STEP track that changes outside keeps its steps there") {
  const MovingBiped moving = withStepOn("foreArm.l", {{0, 10}, {3, 70}, {5, 40}, {20, 90}, {23, 5}});
  Trail trail = connectedTrail("left-arm", 8, 12, 2.0);
  trail.settings.bend = Bend::straighten;
  trail.settings.releaseFrames = 4.0;
  const Rekeyed rekeyed = rekeyedOf(moving, {trail});
  const Track& track = rekeyedTrack(rekeyed, moving.node.at("foreArm.l"), Channel::rotation);
  CHECK(std::ranges::is_sorted(track.times));
  CHECK(std::ranges::adjacent_find(track.times) == track.times.end());
  for (double frame = 0.013; frame <= 24.0; frame += 0.05) {
    if (frame < 8.0 || frame > 16.0) {
      CAPTURE(frame);
      CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, frame), sourceAtFrame(moving, frame)) <
            1e-6 * moving.body.height);
    }
  }
}

TEST_CASE("a step right at the range's start stays a step") {
  for (const double release : {0.0, 4.0}) {
    const MovingBiped moving = withStepOn("foreArm.l", {{0, 10}, {8, 70}, {12, 40}, {16, 80}});
    Trail trail = connectedTrail("left-arm", 8, 12, 2.0);
    trail.settings.bend = Bend::straighten;
    trail.settings.releaseFrames = release;
    const Rekeyed rekeyed = rekeyedOf(moving, {trail});
    for (const double frame : {1.0, 7.0, 7.99, 12.01 + release, 16.01, 20.0}) {
      CAPTURE(release, frame);
      CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, frame), sourceAtFrame(moving, frame)) <
            1e-6 * moving.body.height);
    }
  }
}

TEST_CASE("a STEP track with one key holds it") {
  const MovingBiped moving = withStepOn("foreArm.l", {{0, 40}});
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.bend = Bend::straighten;
  const Rekeyed rekeyed = rekeyedOf(moving, {trail});
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/limb.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// The same turns, told by the other of their two quaternions at every second key: what exporters write that
// take each key by itself.
MovingBiped withFlippedKeys() {
  MovingBiped moving = punchingBiped(Interpolation::linear);
  for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
    leaf.edit([](Track& track) {
      for (std::size_t i = 0; track.channel == Channel::rotation && i < track.values.size(); ++i) {
        track.values[i] *= i / 4 % 2 == 1 ? -1.0F : 1.0F;
      }
    });
  }
  return moving;
}

// A trail that throws the left arm to where it points away from in frame 9, passing on one side or the other:
// turns of more than half a half circle, of which a quaternion has either sign.
Trail thrownBack(const MovingBiped& moving, double side) {
  constexpr double frame = 9.0;
  const FrameState source = sourceAtFrame(moving, frame);
  const Limb& arm = moving.limb("left-arm");
  const Vec3 reach = endPosition(arm, source) - positionOf(source.worlds[at(arm.joints.front())]);
  const Vec3 across = glm::length(reach) * glm::normalize(glm::cross(reach, Vec3(0.1, 1.0, 0.2)));
  Trail trail = connectedTrail("left-arm", 0, 18, 1.0);
  trail.controlFrames = {0.0, 6.0, frame, 12.0, 18.0};
  trail.settings.spheres = {{6.0, side * across - reach},
                            {frame, 0.2 * side * across - 1.9 * reach},
                            {12.0, side * across - reach}};
  trail.settings.releaseFrames = 3.0;
  return trail;
}

// Without keys of its own for the arm: what is written is cubic where others of the limb are.
void eraseTurns(MovingBiped& moving, NodeIndex node) {
  std::erase_if(moving.clip.tracks, [&](const CopyOnWrite<Track>& track) {
    return track->channel == Channel::rotation && track->node == node;
  });
}

Vec4 valueAt(const Track& track, std::size_t key) {
  const std::size_t perKey = track.interpolation == Interpolation::cubicSpline ? 12 : 4;
  const std::size_t first = key * perKey + (perKey == 12 ? 4 : 0);
  return {track.values[first], track.values[first + 1], track.values[first + 2], track.values[first + 3]};
}

// Neighbouring keys from `first` to `last`, frames, that a reader would turn between the long way round.
int longWays(const Track& track, double first, double last) {
  int count = 0;
  for (std::size_t i = 1; i < track.times.size(); ++i) {
    const bool inside = 24.0 * static_cast<double>(track.times[i - 1]) > first - 1e-3 &&
                        24.0 * static_cast<double>(track.times[i]) < last + 1e-3;
    count += inside && glm::dot(valueAt(track, i - 1), valueAt(track, i)) < 0.0 ? 1 : 0;
  }
  return count;
}

} // namespace

TEST_CASE("keys of ours follow each other the short way, also for a reader that looks at no signs") {
  const MovingBiped moving = withFlippedKeys();
  const Rekeyed rekeyed = rekeyedOf(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  int turning = 0;
  for (const Track& track : rekeyed.keys.tracks) {
    if (track.channel == Channel::rotation) {
      ++turning;
      CAPTURE(track.node.value);
      CHECK(longWays(track, 0.0, 12.0) == 0);
    }
  }
  CHECK(turning > 0);
}

TEST_CASE("a curve that comes to our keys on the other hemisphere keeps its shape outside of them") {
  for (const double flip : {1.0, -1.0}) {
    MovingBiped moving = punchingBiped(Interpolation::cubicSpline);
    for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
      leaf.edit([&](Track& track) {
        for (float& value : track.values) {
          value *= track.channel == Channel::rotation ? static_cast<float>(flip) : 1.0F;
        }
      });
    }
    Trail trail = connectedTrail("left-arm", 7, 11, 2.5);
    trail.settings.releaseFrames = 3.0;
    const Rekeyed rekeyed = rekeyedOf(moving, {trail});
    CAPTURE(flip);
    CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
    for (double frame = 0.0; frame <= 24.0; frame += 0.25) {
      if (frame < 7.0 || frame > 14.0) {
        CAPTURE(frame);
        CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, frame), sourceAtFrame(moving, frame)) <
              1e-6 * moving.body.height);
      }
    }
  }
}

TEST_CASE("an arm that is thrown back is keyed the short way, on whichever side it passes") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    for (const double side : {1.0, -1.0}) {
      for (const bool keyed : {true, false}) {
        MovingBiped moving = punchingBiped(interpolation);
        if (!keyed) {
          eraseTurns(moving, moving.node.at("upperArm.l"));
        }
        const Rekeyed rekeyed = rekeyedOf(moving, {thrownBack(moving, side)});
        CAPTURE(static_cast<int>(interpolation), side, keyed);
        CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
        for (const Track& track : rekeyed.keys.tracks) {
          if (track.channel == Channel::rotation) {
            CAPTURE(track.node.value);
            CHECK(longWays(track, 0.0, 24.0) == 0);
          }
        }
      }
    }
  }
}

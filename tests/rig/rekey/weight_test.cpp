#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/rekey/bind_leaves.h"
#include "rig/rekey/rekey.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/rekeyed_clip.h"
#include "tests/support/rig/soft_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// A load that turns around the bone while it swells and dies away, across both zero crossings.
SoftBones turning(double frame) {
  const double u = frame / 24.0;
  const double swell = std::sin(3.0 * pi * u);
  const double angle = 7.0 * u;
  return {1.0 + 0.15 * swell, 1.0 - 0.08 * std::abs(swell), 1.0 + 0.06 * std::abs(swell),
          Vec3(0.3, std::cos(angle), std::sin(angle)), 0.0};
}

SoftBones standing(double frame) {
  SoftBones bones = turning(frame);
  bones.planted = frame < 10.0 ? 1.0 : std::max(0.0, 1.0 - 0.25 * (frame - 10.0));
  return bones;
}

Rekeyed keyed(const MovingBiped& moving, const MotionState& motion, const RekeyOptions& options = {}) {
  RekeyOptions used = options;
  used.tolerance = 0.5e-4 * moving.body.height;
  Rekeyed rekeyed{motion, {}, {}};
  rekeyed.keys = rekey(moving.scene, moving.clip, rekeyed.motion, used);
  rekeyed.clip = withTracks(moving.clip, rekeyed.keys.tracks);
  return rekeyed;
}

double worstStretchMiss(const MovingBiped& moving, const Rekeyed& rekeyed) {
  double worst = 0.0;
  for (int half = 0; half <= 48; ++half) {
    const double frame = 0.5 * half;
    const FrameState exact = atFrame(moving, rekeyed.motion, frame);
    for (const StretchKeys& keys : rekeyed.keys.stretches) {
      const Mat3 wanted = exact.stretch.empty() ? Mat3(1.0) : exact.stretch[at(keys.node)];
      const Mat3 written = stretchOf(keys, frame / moving.clip.framesPerSecond);
      for (int column = 0; column < 3; ++column) {
        worst = std::max(worst, glm::length(written[column] - wanted[column]));
      }
    }
  }
  return worst;
}

std::vector<Trail> punch() {
  return {connectedTrail("left-arm", 0, 12, 2.5)};
}

} // namespace

TEST_CASE("keys of a limb with weight follow it at every frame and half frame, alone and on top of a trail") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    const MovingBiped moving = punchingBiped(interpolation);
    for (const bool withTrail : {false, true}) {
      CAPTURE(static_cast<int>(interpolation), withTrail);
      const MotionState motion =
          softMotion(moving, withTrail ? punch() : std::vector<Trail>{},
                     {softLimb(moving, "left-arm", turning), softLimb(moving, "left-leg", standing),
                      softLimb(moving, "right-leg", turning)});
      const Rekeyed rekeyed = keyed(moving, motion);
      CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
      CHECK(worstStretchMiss(moving, rekeyed) < 1e-3);
    }
  }
}

TEST_CASE("a trail that ends without release jumps inside the range of weight as it does outside") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails = punch();
  trails[0].settings.releaseFrames = 0.0;
  const MotionState motion = softMotion(moving, trails, {softLimb(moving, "left-arm", turning)});
  const Rekeyed rekeyed = keyed(moving, motion);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  CHECK(worstStretchMiss(moving, rekeyed) < 1e-3);
}

TEST_CASE("keys outside a range of weight are the source's bit for bit") {
  const MovingBiped moving = punchingBiped();
  LimbWeight weight = softLimb(moving, "left-leg", standing);
  weight.startSeconds = 0.25;
  weight.endSeconds = 0.5;
  weight.fadeInSeconds = 0.05;
  weight.fadeOutSeconds = 0.05;
  const Rekeyed rekeyed = keyed(moving, softMotion(moving, {}, {weight}));
  REQUIRE_FALSE(rekeyed.keys.tracks.empty());
  for (const Track& track : rekeyed.keys.tracks) {
    const Track* const source = sourceTrack(moving.clip, track.node, track.channel);
    for (const float time : {0.0F, 0.75F, 1.0F}) {
      if (source != nullptr) {
        CHECK(keyNumbers(track, time) == keyNumbers(*source, time));
      }
    }
  }
}

TEST_CASE("axes of a stretch that is not round across the bone turn little from key to key") {
  const MovingBiped moving = punchingBiped();
  const Rekeyed rekeyed = keyed(moving, softMotion(moving, {}, {softLimb(moving, "left-arm", turning)}));
  REQUIRE_FALSE(rekeyed.keys.stretches.empty());
  for (const StretchKeys& keys : rekeyed.keys.stretches) {
    REQUIRE_FALSE(keys.axisIsFixed());
    for (std::size_t i = 1; i < keys.axes.size(); ++i) {
      CHECK(std::abs(glm::dot(keys.axes[i], keys.axes[i - 1])) > 0.7);
    }
  }
}

TEST_CASE("a stretch round across its bone keeps one fixed set of axes and one leaf") {
  const MovingBiped moving = punchingBiped();
  const auto round = [](double frame) {
    const double along = 1.0 + 0.01 * frame;
    return SoftBones{along, 1.0 / std::sqrt(along), 1.0 / std::sqrt(along), Vec3(0, 1, 0), 0.0};
  };
  const Rekeyed rekeyed = keyed(moving, softMotion(moving, punch(), {softLimb(moving, "left-arm", round)}));
  for (const StretchKeys& keys : rekeyed.keys.stretches) {
    CHECK(keys.axisIsFixed());
  }
  gltf::Edits edits;
  addBindLeaves(moving.scene, {{0, rekeyed.keys.stretches}}, edits);
  CHECK(edits.addedNodes.size() == rekeyed.keys.stretches.size());
}

TEST_CASE("weight over a whole clip of stepped keys has no key before the clip begins") {
  MovingBiped moving = punchingBiped(Interpolation::step);
  for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
    leaf.edit([](Track& track) {
      for (float& time : track.times) {
        time += 0.125F;
      }
    });
  }
  moving.clip.startSeconds = 0.125;
  moving.clip.endSeconds = 1.125;
  LimbWeight weight = softLimb(moving, "left-leg", standing);
  weight.startSeconds = 0.0;
  for (const Track& track : keyed(moving, softMotion(moving, {}, {weight})).keys.tracks) {
    CHECK(track.times.front() >= 0.0F);
  }
}

TEST_CASE("a trail without release jumps at once where its range ends inside that of weight, or begins") {
  const Pivot pivot = GENERATE(Pivot::start, Pivot::end);
  CAPTURE(pivot == Pivot::start);
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails{connectedTrail("left-arm", 6, 15, 2.0)};
  trails[0].settings.releaseFrames = 0.0;
  trails[0].settings.pivot = pivot;
  const Rekeyed rekeyed = keyed(moving, softMotion(moving, trails, {softLimb(moving, "left-arm", turning)}));
  const double beside = pivot == Pivot::start ? 15.0 + 1e-3 : 6.0 - 1e-3;
  CHECK(largestNodeMiss(poseOf(moving, rekeyed.clip, beside), atFrame(moving, rekeyed.motion, beside)) <
        1e-3 * moving.body.height);
}

TEST_CASE("weight that does not fade on one side of its range jumps there at once, its stretch too") {
  const bool jumpsIn = GENERATE(true, false);
  CAPTURE(jumpsIn);
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  LimbWeight weight = softLimb(moving, "left-arm", [](double) { return SoftBones{1.3, 0.9, 0.9}; });
  weight.startSeconds = 0.25;
  weight.endSeconds = 0.75;
  (jumpsIn ? weight.fadeOutSeconds : weight.fadeInSeconds) = 0.125;
  const Rekeyed rekeyed = keyed(moving, softMotion(moving, {}, {weight}));
  const double border = jumpsIn ? 6.0 : 18.0;
  const double beside = jumpsIn ? 6.0 - 1e-3 : 18.0 + 1e-3;
  CHECK(largestNodeMiss(poseOf(moving, rekeyed.clip, beside), sourceAtFrame(moving, beside)) < 1e-6);
  CHECK(lengthOf(arm, poseOf(moving, rekeyed.clip, border)) ==
        Approx(1.3 * lengthOf(arm, sourceAtFrame(moving, border))).epsilon(1e-3));
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  REQUIRE_FALSE(rekeyed.keys.stretches.empty());
  for (const StretchKeys& keys : rekeyed.keys.stretches) {
    CHECK(glm::length(keys.scales.front() - Vec3(1.0)) < 1e-6);
    CHECK(glm::length(keys.scales.back() - Vec3(1.0)) < 1e-6);
  }
}

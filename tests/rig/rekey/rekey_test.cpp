#include "rig/rekey/rekey.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::vector<Trail> armTrail(double start, double end, double scale) {
  return {connectedTrail("left-arm", start, end, scale)};
}

Track slower(Track track, float times) {
  for (float& time : track.times) {
    time *= times;
  }
  for (std::size_t i = 0; track.interpolation == Interpolation::cubicSpline && i < track.values.size(); ++i) {
    const bool isTangent = i / static_cast<std::size_t>(track.width) % 3 != 1;
    track.values[i] /= isTangent ? times : 1.0F;
  }
  return track;
}

// The punch, with its first key half a second after the clip's frame 0.
MovingBiped latePunch() {
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    track.edit([](Track& late) {
      for (float& time : late.times) {
        time += 0.5F;
      }
    });
  }
  moving.clip.startSeconds = 0.5;
  moving.clip.endSeconds = 1.5;
  return moving;
}

} // namespace

TEST_CASE("the re-keyed clip follows the exact motion at every frame and half frame") {
  for (const Interpolation interpolation :
       {Interpolation::linear, Interpolation::cubicSpline, Interpolation::step}) {
    const MovingBiped moving = punchingBiped(interpolation);
    for (const Bend bend : {Bend::keep, Bend::straighten}) {
      for (const double scale : {0.5, 3.0}) {
        std::vector<Trail> trails = armTrail(0, 12, scale);
        trails[0].settings.bend = bend;
        trails[0].settings.overshoot = 0.2;
        const Rekeyed rekeyed = rekeyedOf(moving, trails);
        CAPTURE(static_cast<int>(interpolation), bend == Bend::keep, scale);
        CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
      }
    }
  }
}

TEST_CASE("trails on all limbs together stay within the tolerance") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails;
  for (const Limb& limb : moving.body.limbs) {
    trails.push_back(connectedTrail(limb.id, 2, 12, limb.kind == LimbKind::spine ? 1.3 : 2.0));
    trails.back().id = static_cast<int>(trails.size());
  }
  CHECK(worstMiss(moving, rekeyedOf(moving, trails), 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("keys outside range and release stay bit for bit") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    const MovingBiped moving = punchingBiped(interpolation);
    std::vector<Trail> trails = armTrail(7, 11, 2.0);
    trails[0].settings.releaseFrames = 3.0;
    const Rekeyed rekeyed = rekeyedOf(moving, trails);
    REQUIRE_FALSE(rekeyed.keys.tracks.empty());
    for (const Track& track : rekeyed.keys.tracks) {
      const Track* source = sourceTrack(moving.clip, track.node, track.channel);
      if (source == nullptr) {
        continue;
      }
      CHECK(track.interpolation == source->interpolation);
      for (std::size_t i = 0; i < source->times.size(); ++i) {
        const double frame = 24.0 * static_cast<double>(source->times[i]);
        CAPTURE(track.node, static_cast<int>(track.channel), frame);
        if (frame < 7.0 || frame > 14.0) {
          CHECK(keyNumbers(track, source->times[i]) == keyNumbers(*source, source->times[i]));
        }
      }
    }
  }
}

TEST_CASE("outside range and release the re-keyed motion is the source's") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    const MovingBiped moving = punchingBiped(interpolation);
    for (const double start : {6.0, 7.0, 8.5}) {
      std::vector<Trail> trails = armTrail(start, 11, 2.0);
      trails[0].settings.releaseFrames = 3.3;
      const Rekeyed rekeyed = rekeyedOf(moving, trails);
      for (double frame = 0.0; frame <= 24.0; frame += 0.17) {
        if (frame < start || frame > 14.3) {
          CAPTURE(static_cast<int>(interpolation), start, frame);
          CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, frame), sourceAtFrame(moving, frame)) <
                1e-6 * moving.body.height);
        }
      }
    }
  }
}

TEST_CASE("only what the limb moves is keyed") {
  const MovingBiped moving = punchingBiped();
  const Rekeyed rekeyed = rekeyedOf(moving, armTrail(0, 12, 2.0));
  for (const Track& track : rekeyed.keys.tracks) {
    const bool ofArm = isAncestorOrSelf(moving.scene, moving.node.at("upperArm.l"), track.node);
    CHECK(ofArm);
    CHECK(track.channel != Channel::scale);
    CHECK(track.node != moving.node.at("finger0a.l"));
  }
}

TEST_CASE("a release of no length jumps back between two neighbouring keys") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    for (const Pivot pivot : {Pivot::start, Pivot::end}) {
      const MovingBiped moving = punchingBiped(interpolation);
      std::vector<Trail> trails = armTrail(6, 15, 2.0);
      trails[0].settings.releaseFrames = 0.0;
      trails[0].settings.pivot = pivot;
      const Rekeyed rekeyed = rekeyedOf(moving, trails);
      const double tip = pivot == Pivot::start ? 15.0 : 6.0;
      const double outside = pivot == Pivot::start ? 15.0 + 1e-3 : 6.0 - 1e-3;
      CAPTURE(static_cast<int>(interpolation), pivot == Pivot::start);
      CHECK(lengthOf(moving.limb("left-arm"), poseOf(moving, rekeyed.clip, tip)) ==
            Approx(2.0 * lengthOf(moving.limb("left-arm"), sourceAtFrame(moving, tip))).epsilon(1e-4));
      CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, outside), sourceAtFrame(moving, outside)) < 1e-6);
      CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
    }
  }
}

TEST_CASE(
    "a limb that is pulled where nothing is scaled, without a release, is the source's beyond the range, its "
    "stretch too") {
  for (const Pivot pivot : {Pivot::start, Pivot::end}) {
    const MovingBiped moving = punchingBiped();
    std::vector<Trail> trails = armTrail(6, 15, 2.0);
    TrailSettings& settings = trails[0].settings;
    settings.releaseFrames = 0.0;
    settings.pivot = pivot;
    const double pulled = pivot == Pivot::start ? 6.0 : 15.0;
    const double outside = pivot == Pivot::start ? 6.0 - 1e-3 : 15.0 + 1e-3;
    settings.spheres = {{pulled, Vec3(0.0, 0.3, 0.2), {}}};
    const Rekeyed rekeyed = rekeyedOf(moving, trails);
    CAPTURE(pivot == Pivot::start);
    CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, pulled), sourceAtFrame(moving, pulled)) > 0.1);
    CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, outside), sourceAtFrame(moving, outside)) < 1e-6);
    CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
    REQUIRE_FALSE(rekeyed.keys.stretches.empty());
    for (const StretchKeys& keys : rekeyed.keys.stretches) {
      const bool startsThere = pivot == Pivot::start;
      CHECK(glm::length((startsThere ? keys.scales.front() : keys.scales.back()) - Vec3(1.0)) < 1e-9);
    }
  }
}

TEST_CASE("a key on every frame is there when it is asked for") {
  const MovingBiped moving = punchingBiped();
  const Rekeyed rekeyed = rekeyedOf(moving, armTrail(0, 12, 2.0), {1e-4, KeyPlaces::everyFrame});
  for (const Track& track : rekeyed.keys.tracks) {
    for (double frame = 0.0; frame <= 18.0; frame += 1.0) {
      const bool there =
          std::ranges::any_of(track.times, [&](float t) { return std::abs(24.0 * t - frame) < 1e-3; });
      CAPTURE(track.node, frame);
      CHECK(there);
    }
  }
}

TEST_CASE("a slow, sparse clip gets few keys") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    MovingBiped moving = punchingBiped(interpolation);
    for (CopyOnWrite<Track>& leaf : moving.clip.tracks) {
      leaf.edit([&](Track& track) { track = slower(track, 8.0F); });
    }
    moving.clip.endSeconds = 8.0;
    const Rekeyed rekeyed = rekeyedOf(moving, armTrail(0, 96, 1.3));
    CHECK(worstMiss(moving, rekeyed, 0, 192) < 1e-4 * moving.body.height);
    for (const Track& track : rekeyed.keys.tracks) {
      CAPTURE(static_cast<int>(interpolation), track.node, static_cast<int>(track.channel));
      CHECK(track.times.size() < (interpolation == Interpolation::linear ? 100 : 50));
    }
  }
}

TEST_CASE("a joint without a channel gets one that holds its rest elsewhere") {
  MovingBiped moving = punchingBiped();
  const NodeIndex foreArm = moving.node.at("foreArm.l");
  std::erase_if(moving.clip.tracks, [&](const CopyOnWrite<Track>& track) {
    return track->node == foreArm || track->node == moving.node.at("hand.l");
  });
  const Rekeyed rekeyed = rekeyedOf(moving, armTrail(6, 12, 2.0));
  const auto added = std::ranges::count_if(rekeyed.keys.tracks, [&](const Track& track) {
    return sourceTrack(moving.clip, track.node, track.channel) == nullptr;
  });
  CHECK(added >= 2);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, 3), sourceAtFrame(moving, 3)) < 1e-6);
  CHECK(largestMatrixMiss(poseOf(moving, rekeyed.clip, 22), sourceAtFrame(moving, 22)) < 1e-6);
}

TEST_CASE("a clip whose first key comes late is keyed from frame 0 as the motion is") {
  const MovingBiped moving = latePunch();
  const Rekeyed rekeyed = rekeyedOf(moving, armTrail(0, 24, 2.0));
  CHECK(worstMiss(moving, rekeyed, 0, 36) < 1e-4 * moving.body.height);
  Trail backwards = connectedTrail("left-arm", 6, 24, 2.0);
  backwards.settings.pivot = Pivot::end;
  backwards.settings.releaseFrames = 4.0;
  CHECK(worstMiss(moving, rekeyedOf(moving, {backwards}), 0, 36) < 1e-4 * moving.body.height);
}

TEST_CASE("two trails one after the other on a limb both hold at their tips") {
  const MovingBiped moving = punchingBiped();
  Trail first = connectedTrail("left-arm", 0, 12, 2.0);
  Trail second = connectedTrail("left-arm", 12, 18, 1.5);
  second.id = 2;
  first.settings.releaseFrames = 4.0;
  const MotionState motion = solved(moving, {first, second});
  const Limb& arm = moving.limb("left-arm");
  CHECK(lengthOf(arm, atFrame(moving, motion, 12)) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  CHECK(lengthOf(arm, atFrame(moving, motion, 18)) ==
        Approx(1.5 * lengthOf(arm, sourceAtFrame(moving, 18))).epsilon(1e-4));
  CHECK(largestNodeMiss(atFrame(moving, motion, 12), atFrame(moving, motion, 12.001)) < 1e-2);
  CHECK(worstMiss(moving, rekeyedOf(moving, {first, second}), 0, 24) < 1e-4 * moving.body.height);
  // In whatever order they were made.
  CHECK(largestMatrixMiss(atFrame(moving, motion, 14), atFrame(moving, solved(moving, {second, first}), 14)) <
        1e-2);
}

TEST_CASE("the answer does not depend on what was evaluated before") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, armTrail(0, 12, 2.0));
  const FrameState fresh = atFrame(moving, motion, 9);
  static_cast<void>(atFrame(moving, motion, 17));
  static_cast<void>(atFrame(moving, motion, 3));
  CHECK(largestMatrixMiss(atFrame(moving, motion, 9), fresh) == 0.0);
  const RekeyedClip once = rekey(moving.scene, moving.clip, motion, {});
  const RekeyedClip twice = rekey(moving.scene, moving.clip, motion, {});
  CHECK(once.tracks == twice.tracks);
}

TEST_CASE("on a loop the keys of the wrapped release are there") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 12, 24, 2.0);
  trail.settings.releaseFrames = 6.0;
  const Rekeyed rekeyed = rekeyedOf(moving, {trail}, {}, true);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("the way out of a loop whose first key comes late is saved at its end, and held before it") {
  const MovingBiped moving = latePunch(); // frames 12 to 36
  Trail trail = connectedTrail("left-arm", 15, 24, 2.0);
  trail.settings.pivot = Pivot::end;
  trail.settings.releaseFrames = 8.0; // from frame 31 on
  const Rekeyed rekeyed = rekeyedOf(moving, {trail}, {}, true);
  const auto isOff = [&](double frame) {
    return largestNodeMiss(poseOf(moving, rekeyed.clip, frame), sourceAtFrame(moving, frame));
  };
  CHECK(isOff(35.0) > 0.05);
  CHECK(isOff(30.5) < 1e-6);
  CHECK(worstMiss(moving, rekeyed, 0, 36) < 1e-4 * moving.body.height);
}

TEST_CASE("the stretch between keys is close to the exact one") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, armTrail(0, 12, 3.0));
  const RekeyedClip rekeyed = rekey(moving.scene, moving.clip, motion, {});
  REQUIRE(rekeyed.stretches.size() == 2);
  for (const StretchKeys& keys : rekeyed.stretches) {
    for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
      const FrameState exact = atFrame(moving, motion, frame);
      const Mat3 wanted = exact.stretch.empty() ? Mat3(1.0) : exact.stretch[at(keys.node)];
      const Mat3 difference = stretchOf(keys, frame / 24.0) - wanted;
      CAPTURE(keys.node, frame);
      CHECK(glm::length(difference[0]) + glm::length(difference[1]) + glm::length(difference[2]) < 5e-3);
    }
  }
}

#include <cmath>
#include <tuple>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/limb.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

Vec3 handOffset(const MovingBiped& moving, const MotionState& motion, double frame) {
  const Limb& arm = moving.limb("left-arm");
  return endPosition(arm, atFrame(moving, motion, frame).worlds) -
         endPosition(arm, sourceAtFrame(moving, frame).worlds);
}

double miss(const MovingBiped& moving, const MotionState& motion, double frame) {
  return largestMatrixMiss(atFrame(moving, motion, frame), sourceAtFrame(moving, frame));
}

} // namespace

TEST_CASE("an unedited clip goes through the rig unchanged") {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
    SyntheticBiped body = namedBody();
    body.posedAtRest = interpolation == Interpolation::cubicSpline;
    MovingBiped moving = still(body);
    addPunch(moving, interpolation);
    std::vector<Trail> trails;
    for (const Limb& limb : moving.body.limbs) {
      for (const Bend bend : {Bend::keep, Bend::straighten}) {
        trails = {connectedTrail(limb.id, 0, 12, 1.0)};
        trails[0].settings.bend = bend;
        Trail unblended = connectedTrail(limb.id, 0, 12, 2.0);
        unblended.settings.bend = bend;
        unblended.settings.blend = 0.0;
        for (const std::vector<Trail>& used : {trails, std::vector<Trail>{unblended}}) {
          const MotionState motion = solved(moving, used);
          for (double frame = 0.0; frame <= 24.0; frame += 1.5) {
            CAPTURE(limb.id, bend == Bend::keep, used[0].settings.scale, frame);
            CHECK(miss(moving, motion, frame) < 1e-5 * moving.body.height);
          }
        }
      }
    }
  }
}

TEST_CASE("a trail that is not connected moves nothing") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 0, 12, 3.0);
  trail.connected = false;
  const MotionState motion = solved(moving, {trail});
  CHECK_FALSE(motion.trails.front().active);
  CHECK(miss(moving, motion, 12) == 0.0);
}

TEST_CASE("outside range and release nothing moves") {
  const MovingBiped moving = punchingBiped();
  for (const Pivot pivot : {Pivot::start, Pivot::end}) {
    Trail trail = connectedTrail("left-arm", 6, 12, 3.0);
    trail.settings.pivot = pivot;
    trail.settings.releaseFrames = 4.0;
    const MotionState motion = solved(moving, {trail});
    const double first = pivot == Pivot::start ? 6.0 : 2.0;
    const double last = pivot == Pivot::start ? 16.0 : 12.0;
    for (double frame = 0.0; frame <= 24.0; frame += 0.25) {
      CAPTURE(pivot == Pivot::start, frame);
      if (frame <= first || frame >= last) {
        CHECK(miss(moving, motion, frame) < 1e-6);
      }
    }
    CHECK(glm::length(handOffset(moving, motion, pivot == Pivot::start ? 14.0 : 4.0)) > 0.01);
  }
}

TEST_CASE("the motion has no jump anywhere with a release") {
  const MovingBiped moving = punchingBiped();
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    for (const Pivot pivot : {Pivot::start, Pivot::end}) {
      Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
      trail.settings.pivot = pivot;
      trail.settings.bend = bend;
      trail.settings.releaseFrames = 6.0;
      trail.settings.overshoot = 0.3;
      const MotionState motion = solved(moving, {trail});
      for (const double border : {0.0, 6.0, 12.0, 18.0}) {
        CAPTURE(bend == Bend::keep, pivot == Pivot::start, border);
        CHECK(largestNodeMiss(atFrame(moving, motion, border - 1e-4),
                              atFrame(moving, motion, border + 1e-4)) < 1e-3);
      }
    }
  }
}

TEST_CASE("the default release of a sparsely keyed clip goes to the controller's next key") {
  const MovingBiped moving = punchingBiped();
  const MotionState forwards = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(forwards.trails.front().release.seconds() == Approx(0.25));
  Trail trail = connectedTrail("left-arm", 12, 24, 2.0);
  trail.settings.pivot = Pivot::end;
  CHECK(solved(moving, {trail}).trails.front().release.seconds() == Approx(0.25));
}

TEST_CASE("the default release of a densely keyed clip is a third of the range, within the clip") {
  MovingBiped moving = punchingBiped();
  moving.clip = keyedOnEveryFrame(moving.clip);
  CHECK(solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)}).trails.front().release.seconds() ==
        Approx(4.0 / 24.0));
  CHECK(solved(moving, {connectedTrail("left-arm", 6, 22, 2.0)}).trails.front().release.seconds() ==
        Approx(2.0 / 24.0));
  CHECK(solved(moving, {connectedTrail("left-arm", 6, 24, 2.0)}).trails.front().release.seconds() == 0.0);
}

TEST_CASE("the default release takes the limb back no faster than it came, and ends on a frame") {
  MovingBiped moving = punchingBiped();
  moving.clip = keyedOnEveryFrame(moving.clip);
  const Trail trail = connectedTrail("left-arm", 9, 12, 4.0);
  const MotionState motion = solved(moving, {trail});
  const Limb& arm = moving.limb("left-arm");
  const auto reachAt = [&](double frame) {
    const FrameState pose = atFrame(moving, motion, frame);
    return endPosition(arm, pose.worlds) - positionOf(pose.worlds[at(arm.joints.front())]);
  };
  const auto fastest = [&](double from, double to) {
    double most = 0.0;
    for (double frame = from; frame < to; frame += 1.0) {
      most = std::max(most, glm::length(reachAt(frame + 1.0) - reachAt(frame)));
    }
    return most;
  };
  const double release = motion.trails.front().release.seconds() * 24.0;
  CHECK(release > 1.5); // A third of the range is a single frame.
  CHECK(release == Approx(std::round(release)));
  CHECK(fastest(12.0, 12.0 + release) < 1.15 * fastest(9.0, 12.0)); // The arm goes back by itself as well.
}

TEST_CASE("a release of no length gives the source back right after the tip") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
  trail.settings.releaseFrames = 0.0;
  const MotionState motion = solved(moving, {trail});
  CHECK(glm::length(handOffset(moving, motion, 12.0)) > 0.1);
  CHECK(miss(moving, motion, 12.001) == 0.0);
}

TEST_CASE("the tip is met where its key is stored in single precision, however late in the clip") {
  MovingBiped moving = punchingBiped();
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    track.edit([](Track& late) {
      for (float& time : late.times) {
        time += 70.0F;
      }
    });
  }
  moving.clip.startSeconds = 70.0;
  moving.clip.endSeconds = 71.0;
  for (double tip = 1684.0; tip < 1700.0; tip += 1.0) {
    Trail trail = connectedTrail("left-arm", 1680, tip, 2.0);
    trail.settings.releaseFrames = 0.0;
    const MotionState motion = solved(moving, {trail});
    const auto seconds = static_cast<double>(static_cast<float>(tip / 24.0));
    CAPTURE(tip);
    CHECK(glm::length(handOffset(moving, motion, seconds * 24.0) - handOffset(moving, motion, tip)) < 1e-4);
  }
}

TEST_CASE("the release swings past the original by the overshoot") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
  trail.settings.releaseFrames = 8.0;
  trail.settings.overshoot = 0.4;
  const MotionState motion = solved(moving, {trail});
  const Vec3 atTip = handOffset(moving, motion, 12.0);
  double lowest = 1.0;
  for (double frame = 12.0; frame <= 20.0; frame += 0.1) {
    lowest = std::min(lowest, glm::dot(handOffset(moving, motion, frame), atTip) / glm::dot(atTip, atTip));
  }
  CHECK(lowest == Approx(-0.4).margin(0.01));
}

TEST_CASE("on a loop the release wraps to the clip's start, without a jump where it repeats") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 12, 24, 2.0);
  trail.settings.releaseFrames = 6.0;
  const MotionState motion = solved(moving, {trail}, true);
  CHECK(glm::length(handOffset(moving, motion, 24.0)) > 0.05);
  CHECK(glm::length(handOffset(moving, motion, 0.0) - handOffset(moving, motion, 24.0)) < 1e-3);
  CHECK(glm::length(handOffset(moving, motion, 0.001) - handOffset(moving, motion, 24.0)) < 1e-3);
  CHECK(glm::length(handOffset(moving, motion, 6.0)) < 1e-6);
  CHECK(miss(moving, motion, 8.0) == 0.0);
}

TEST_CASE("on a loop a release ends where the range begins again, without a jump there") {
  const MovingBiped moving = punchingBiped();
  for (const Pivot pivot : {Pivot::start, Pivot::end}) {
    Trail trail = connectedTrail("left-arm", 4, 20, 2.0);
    trail.settings.pivot = pivot;
    trail.settings.releaseFrames = 14.0; // Of which the loop of 24 frames has room for 8.
    const MotionState motion = solved(moving, {trail}, true);
    CHECK(motion.trails.front().release.seconds() * motion.framesPerSecond == Approx(8.0));
    const double again = pivot == Pivot::start ? 4.0 : 20.0;
    const Vec3 before = handOffset(moving, motion, again - 1e-4);
    const Vec3 after = handOffset(moving, motion, again + 1e-4);
    CAPTURE(pivot == Pivot::start, glm::length(before), glm::length(after));
    CHECK(glm::length(after - before) < 1e-3 * moving.body.height);
  }
}

TEST_CASE("on a loop a hand that is pulled at the pivot goes back and fades in again without a jump") {
  const MovingBiped moving = punchingBiped();
  const auto [pivot, pulled] = GENERATE(table<Pivot, double>({{Pivot::start, 3.0}, {Pivot::end, 18.0}}));
  CAPTURE(pulled);
  Trail trail = connectedTrail("left-arm", 3, 18, 1.5);
  trail.settings.pivot = pivot;
  trail.settings.releaseFrames = GENERATE(3.0, 7.0, 20.0); // The loop of 24 frames leaves 9.
  trail.settings.spheres = {{pulled, Vec3(0.0, 0.3, 0.0)}};
  const Rekeyed rekeyed = rekeyedOf(moving, {trail}, {}, true);
  const MotionState& motion = rekeyed.motion;
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  CHECK(glm::length(handOffset(moving, motion, pulled) - Vec3(0.0, 0.3, 0.0)) < 1e-5);
  CHECK(glm::length(handOffset(moving, motion, 24.0) - handOffset(moving, motion, 0.0)) < 1e-3);
  for (double frame = 0.0; frame < 24.0; frame += 0.25) {
    CAPTURE(frame);
    const Vec3 after = handOffset(moving, motion, frame + 1e-3);
    CHECK(glm::length(after - handOffset(moving, motion, frame)) < 1e-3);
  }
}

TEST_CASE("the hand keeps its offset while the release lingers, on either side of the pivot") {
  const MovingBiped moving = punchingBiped();
  for (const Pivot pivot : {Pivot::start, Pivot::end}) {
    Trail trail = connectedTrail("left-arm", 8, 14, 2.0);
    trail.settings.pivot = pivot;
    trail.settings.releaseFrames = 6.0;
    trail.settings.lingerFrames = 2.0;
    const MotionState motion = solved(moving, {trail});
    const double tip = pivot == Pivot::start ? 14.0 : 8.0;
    const double away = pivot == Pivot::start ? 1.0 : -1.0;
    const Vec3 offset = handOffset(moving, motion, tip);
    CAPTURE(pivot == Pivot::start);
    CHECK(glm::length(handOffset(moving, motion, tip + 2.0 * away) - offset) < 1e-6);
    CHECK(glm::length(handOffset(moving, motion, tip + 4.0 * away) - 0.5 * offset) < 1e-6);
    CHECK(miss(moving, motion, tip + 6.0 * away) < 1e-9);
  }
}

TEST_CASE("before its first key a clip that loops holds what it has there, the way back as well") {
  MovingBiped moving = punchingBiped();
  moving.clip.startSeconds = 1.0 / 24.0;
  Trail trail = connectedTrail("left-arm", 12, 23, 2.0);
  trail.settings.releaseFrames = 6.0;
  const MotionState motion = solved(moving, {trail}, true);
  CHECK(glm::length(handOffset(moving, motion, 1.0)) > 1e-3);
  for (const double frame : {0.0, 0.5}) {
    CHECK(glm::length(handOffset(moving, motion, frame) - handOffset(moving, motion, 1.0)) < 1e-9);
  }
}

TEST_CASE(
    "the drawn way out of a loop goes where the hand goes at its end, however late its first key comes") {
  MovingBiped moving = punchingBiped();
  moving.clip.startSeconds = 6.0 / 24.0;
  Trail trail = connectedTrail("left-arm", 8, 14, 2.0);
  trail.settings.pivot = Pivot::end;
  trail.settings.releaseFrames = 6.0;
  const MotionState motion = solved(moving, {trail}, true);
  const DrawnTrail drawn =
      pathsAt(moving.scene, moving.clip, motion, 0, drawnFrames(moving.clip, motion.trails.front(), 1, true));
  REQUIRE(drawn.frames.front() == Approx(2.0));
  for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
    const double frame = drawn.frames[i] < 6.0 ? drawn.frames[i] + 18.0 : drawn.frames[i];
    CAPTURE(frame);
    CHECK(glm::length(drawn.exaggerated[i] -
                      endPosition(moving.limb("left-arm"), atFrame(moving, motion, frame).worlds)) < 1e-4);
  }
}

TEST_CASE("the hand comes as far as the stop plane and not past it") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  Trail trail = connectedTrail("left-arm", 0, 12, 3.0);
  const Vec3 original = endPosition(arm, sourceAtFrame(moving, 12).worlds);
  const Vec3 stretched = endPosition(arm, atFrame(moving, solved(moving, {trail}), 12).worlds);
  const Vec3 normal = 7.0 * glm::normalize(stretched - original);
  trail.settings.stopAt = StopPlane{original + 0.4 * (stretched - original), normal};
  const MotionState motion = solved(moving, {trail});
  for (double frame = 0.0; frame <= 18.0; frame += 0.25) {
    const Vec3 hand = endPosition(arm, atFrame(moving, motion, frame).worlds);
    CHECK(glm::dot(normal, hand - trail.settings.stopAt->point) < 1e-4);
  }
  const Vec3 tip = endPosition(arm, atFrame(moving, motion, 12).worlds);
  CHECK(std::abs(glm::dot(normal, tip - trail.settings.stopAt->point)) < 1e-5);
}

TEST_CASE("a pulled sphere moves the hand by its offset, one at the pivot fades in") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 6, 18, 1.0);
  trail.settings.releaseFrames = 4.0;
  trail.settings.spheres = {{12.0, Vec3(0.05, 0.1, -0.02)}};
  const MotionState middle = solved(moving, {trail});
  CHECK(glm::length(handOffset(moving, middle, 12.0) - Vec3(0.05, 0.1, -0.02)) < 1e-5);
  CHECK(miss(moving, middle, 5.0) == 0.0);

  // Before the range where that begins at the pivot, after it where it ends there.
  for (const auto& [pivot, frame, away] : {std::tuple(Pivot::start, 6.0, -1.0), {Pivot::end, 18.0, 1.0}}) {
    CAPTURE(frame);
    trail.settings.pivot = pivot;
    trail.settings.spheres = {{frame, Vec3(0.05, 0.1, -0.02)}};
    const MotionState pulled = solved(moving, {trail});
    CHECK(glm::length(handOffset(moving, pulled, frame) - Vec3(0.05, 0.1, -0.02)) < 1e-5);
    CHECK(glm::length(handOffset(moving, pulled, frame + 2.0 * away) - 0.5 * Vec3(0.05, 0.1, -0.02)) < 1e-5);
    CHECK(miss(moving, pulled, frame + 4.0 * away) < 1e-6);
  }
}

TEST_CASE("a sphere outside the range pulls nothing until the range reaches it again") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.releaseFrames = 3.0;
  const MotionState without = solved(moving, {trail});
  const Vec3 pull(0.05, 0.1, -0.02);
  trail.settings.spheres = {{GENERATE(3.0, 15.0), pull}};
  const double sphere = trail.settings.spheres.front().frame;
  const MotionState outside = solved(moving, {trail});
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    CAPTURE(sphere, frame);
    CHECK(glm::length(handOffset(moving, outside, frame) - handOffset(moving, without, frame)) < 1e-9);
  }
  trail.settings.scale = 1.0;
  trail.settings.startFrame = 2.0;
  trail.settings.endFrame = 18.0;
  CHECK(glm::length(handOffset(moving, solved(moving, {trail}), sphere) - pull) < 1e-5);
}

TEST_CASE("past the last key a stretched limb is held, as the keys of the file hold it") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, {connectedTrail("left-leg", 0, 24, 2.0)});
  const FrameState last = atFrame(moving, motion, 24);
  REQUIRE(miss(moving, motion, 24) > 0.01 * moving.body.height);
  CHECK(largestMatrixMiss(atFrame(moving, motion, 24.25), last) == 0.0);
}

TEST_CASE("a trail fades in beside its pivot where the sphere there is pulled, and only there") {
  const MovingBiped moving = punchingBiped();
  const Pivot pivot = GENERATE(Pivot::start, Pivot::end);
  const double pulled = GENERATE(6.0, 9.0, 12.0);
  CAPTURE(static_cast<int>(pivot), pulled);
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.pivot = pivot;
  trail.settings.releaseFrames = 3.0;
  trail.settings.spheres = {{pulled, Vec3(0.0, 0.1, 0.0)}};
  const MotionState motion = solved(moving, {trail});
  const SolvedTrail& made = motion.trails.front();
  const bool fadesBefore = pivot == Pivot::start && pulled == 6.0;
  const bool fadesAfter = pivot == Pivot::end && pulled == 12.0;
  // Three frames of release beyond the tip, and as many to fade in before the pivot.
  const bool releasesBefore = pivot == Pivot::end;
  CHECK(24.0 * made.windowStartSeconds == Approx(releasesBefore || fadesBefore ? 3.0 : 6.0));
  CHECK(24.0 * made.windowEndSeconds == Approx(!releasesBefore || fadesAfter ? 15.0 : 12.0));
}

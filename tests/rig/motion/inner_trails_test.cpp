#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/held_biped.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::vector<Trail> spineAndArm(double spineScale, double armScale, bool stayInWorld) {
  std::vector<Trail> trails{connectedTrail("left-arm", 0, 12, armScale),
                            connectedTrail("spine", 0, 12, spineScale)};
  trails[0].settings.stayInWorld = stayInWorld;
  trails[1].id = 2;
  return trails;
}

Vec3 place(const MovingBiped& moving, const FrameState& frame, const std::string& key) {
  return positionOf(frame.worlds[at(moving.node.at(key))]);
}

} // namespace

TEST_CASE("trails act from the root outwards, whatever the order they were made in") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails = spineAndArm(1.5, 2.0, false);
  const MotionState one = solved(moving, trails);
  std::swap(trails[0], trails[1]);
  const MotionState other = solved(moving, trails);
  CHECK(one.trails.front().limb.id == "spine");
  CHECK(largestMatrixMiss(atFrame(moving, one, 10), atFrame(moving, other, 10)) == 0.0);
}

TEST_CASE("an arm on a stretched spine rides along and holds its own length at its tip") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    std::vector<Trail> trails = spineAndArm(1.6, 2.0, false);
    trails[0].settings.bend = bend;
    trails[1].settings.bend = bend;
    const MotionState motion = solved(moving, trails);
    const FrameState before = sourceAtFrame(moving, 12);
    const FrameState after = atFrame(moving, motion, 12);
    CAPTURE(bend == Bend::keep);
    CHECK(glm::length(place(moving, after, "upperArm.l") - place(moving, before, "upperArm.l")) > 0.05);
    CHECK(lengthOf(arm, after) == Approx(2.0 * lengthOf(arm, before)).epsilon(1e-4));
    CHECK(lengthOf(moving.limb("spine"), after) ==
          Approx(1.6 * lengthOf(moving.limb("spine"), before)).epsilon(1e-4));
    CHECK(worstMiss(moving, rekeyedOf(moving, trails), 0, 24) < 1e-4 * moving.body.height);
  }
}

TEST_CASE("what hangs on a stretched spine keeps its size") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, {connectedTrail("spine", 0, 12, 1.6)});
  const FrameState before = sourceAtFrame(moving, 12);
  const FrameState after = atFrame(moving, motion, 12);
  for (const std::string limb : {"left-arm", "right-arm", "left-leg", "right-leg", "neck"}) {
    CAPTURE(limb);
    CHECK(lengthOf(moving.limb(limb), after) == Approx(lengthOf(moving.limb(limb), before)).epsilon(1e-9));
  }
  CHECK(glm::length(place(moving, after, "foot.l") - place(moving, before, "foot.l")) < 1e-9);
}

TEST_CASE("a hand that stays in the world is where its own trail wants it, whatever the spine does") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Trail> both = spineAndArm(1.6, 1.2, true);
  const MotionState motion = solved(moving, both);
  Trail alone = both[0];
  alone.settings.stayInWorld = false;
  const MotionState armOnly = solved(moving, {alone});
  for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
    CAPTURE(frame);
    CHECK(glm::length(place(moving, atFrame(moving, motion, frame), "hand.l") -
                      place(moving, atFrame(moving, armOnly, frame), "hand.l")) < 1e-4);
  }
  CHECK(worstMiss(moving, rekeyedOf(moving, both), 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("a saved hand stays in the world where the spine's way back goes on at a loop's start") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails{connectedTrail("left-arm", 14, 20, 1.0), connectedTrail("spine", 12, 23, 1.6)};
  trails[0].settings.stayInWorld = true;
  trails[1].settings.releaseFrames = 8.0; // until frame 7
  const Rekeyed rekeyed = rekeyedOf(moving, trails, {}, true);
  const auto isOff = [&](const std::string& key, double frame) {
    return glm::length(place(moving, poseOf(moving, rekeyed.clip, frame), key) -
                       place(moving, sourceAtFrame(moving, frame), key));
  };
  CHECK(isOff("upperArm.l", 1.0) > 0.02);
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    CAPTURE(frame);
    CHECK(isOff("hand.l", frame) < 1e-4 * moving.body.height);
  }
}

TEST_CASE("a saved hand stays in the world on both sides of a jump of the spine") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails{connectedTrail("left-arm", 4, 8, 1.0), connectedTrail("spine", 4, 12, 1.6)};
  trails[0].settings.stayInWorld = true;
  trails[1].settings.releaseFrames = 0.0;
  trails[1].settings.pivot = GENERATE(Pivot::start, Pivot::end);
  const Rekeyed rekeyed = rekeyedOf(moving, trails);
  for (const double frame : {3.99, 4.0, 4.01, 8.0, 11.99, 12.0, 12.01, 13.0}) {
    CAPTURE(frame);
    CHECK(glm::length(place(moving, poseOf(moving, rekeyed.clip, frame), "hand.l") -
                      place(moving, sourceAtFrame(moving, frame), "hand.l")) < 1e-3 * moving.body.height);
  }
}

TEST_CASE("an arm's own jump is saved where the spine that it works against goes on moving") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails{connectedTrail("left-arm", 4, 8, 2.0), connectedTrail("spine", 4, 12, 1.6)};
  trails[0].settings.stayInWorld = true;
  trails[0].settings.releaseFrames = 0.0;
  const Rekeyed rekeyed = rekeyedOf(moving, trails);
  const auto isOff = [&](double frame) {
    return glm::length(place(moving, poseOf(moving, rekeyed.clip, frame), "hand.l") -
                       place(moving, sourceAtFrame(moving, frame), "hand.l"));
  };
  CHECK(isOff(8.0) > 0.1);
  CHECK(isOff(8.01) < 1e-3 * moving.body.height);
}

TEST_CASE("a stop plane holds for a limb that is carried") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails = spineAndArm(1.4, 2.0, false);
  const Vec3 free = place(moving, atFrame(moving, solved(moving, trails), 12), "hand.l");
  const Vec3 carried = place(moving, atFrame(moving, solved(moving, {trails[1]}), 12), "hand.l");
  const Vec3 point = 0.5 * (free + carried);
  trails[0].settings.stopAt = StopPlane{point, free - carried};
  const Vec3 stopped = place(moving, atFrame(moving, solved(moving, trails), 12), "hand.l");
  CHECK(std::abs(glm::dot(glm::normalize(free - carried), stopped - point)) < 1e-5);
}

TEST_CASE("the drawn paths are where the carried hand goes") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails = spineAndArm(1.4, 2.0, false);
  Trail next = connectedTrail("left-arm", 12, 18, 0.8);
  next.id = 3;
  trails.push_back(next);
  const MotionState motion = solved(moving, trails);
  const MotionState spineOnly = solved(moving, {trails[1]});
  for (std::size_t i = 1; i < motion.trails.size(); ++i) {
    const SolvedTrail& trail = motion.trails[i];
    const DrawnTrail drawn = pathsAt(moving.scene, moving.clip, motion, i,
                                     {trail.settings.startFrame + 1, trail.settings.endFrame});
    for (std::size_t k = 0; k < drawn.frames.size(); ++k) {
      CAPTURE(i, drawn.frames[k]);
      CHECK(glm::length(drawn.exaggerated[k] -
                        place(moving, atFrame(moving, motion, drawn.frames[k]), "hand.l")) < 1e-4);
      CHECK(glm::length(drawn.original[k] -
                        place(moving, atFrame(moving, spineOnly, drawn.frames[k]), "hand.l")) < 1e-4);
    }
  }
}

TEST_CASE("a trail that the character does not follow carries the path of no other one") {
  const MovingBiped moving = punchingBiped();
  std::vector<Trail> trails = spineAndArm(1.6, 2.0, false);
  trails[1].connected = false;
  const MotionState motion = solved(moving, trails);
  const std::vector<double> frames{4.0, 12.0};
  const DrawnTrail beside = pathsAt(moving.scene, moving.clip, motion, 1, frames);
  const DrawnTrail alone = pathsAt(moving.scene, moving.clip, solved(moving, {trails[0]}), 0, frames);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    CHECK(glm::length(beside.original[k] - alone.original[k]) < 1e-9);
    CHECK(glm::length(beside.exaggerated[k] - alone.exaggerated[k]) < 1e-9);
  }
}

TEST_CASE("a hold keeps the path that the character follows, and none of the same hand that it does not") {
  const MovingBiped moving = punchingBiped();
  Trail next = connectedTrail("left-arm", 12, 18, 0.8);
  next.id = 2;
  next.connected = false;
  Holds holds;
  holds.pins = {pinAt("left-arm", heldOver(0, 24), 6)};
  const MotionState motion = held(motionInput(moving, {connectedTrail("left-arm", 0, 12, 2.0), next}), holds);
  const std::vector<double> frames{12.0};
  const std::vector<DrawnTrail> both =
      pathsAt(moving.scene, moving.clip, motion, {PathRequest{0, frames}, PathRequest{1, frames}});
  CHECK(glm::length(both[0].exaggerated[0] - place(moving, sourceAtFrame(moving, 6), "hand.l")) < 1e-6);
  CHECK(both[1] == pathsAt(moving.scene, moving.clip, motion, 1, frames));
}

// What a limb does at the plane where it stops.
#include <cmath>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/limb.h"
#include "rig/motion/stop.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double strikes = 12.0; ///< Frame at which the hand of the pressing biped comes to rest.

/// A biped whose left hand strikes at frame 12 and stays there up to frame 24.
MovingBiped pressingBiped() {
  MovingBiped moving = still(namedBody());
  const auto turns = [&](const std::string& joint, const Vec3& axis, double from, double to) {
    const NodeIndex node = moving.node.at(joint);
    const Quat rest = moving.scene.nodes[at(node)].rest.rotation;
    const auto turned = [&](double degrees) {
      return axisAngle(glm::normalize(axis), degrees * pi / 180.0) * rest;
    };
    moving.clip.tracks.emplace_back(rotationTrack(
        node, Interpolation::linear, {{0.0, turned(from)}, {0.5, turned(to)}, {1.0, turned(to)}}));
  };
  turns("upperArm.l", {0.2, 1.0, 0.3}, 50.0, -75.0);
  turns("foreArm.l", {0.0, 1.0, 0.1}, -110.0, -30.0);
  moving.clip.endSeconds = 1.0;
  return moving;
}

Vec3 handIn(const MovingBiped& moving, const FrameState& frame) {
  return endPosition(moving.limb("left-arm"), frame.worlds);
}

Vec3 handOfSource(const MovingBiped& moving, double frame) {
  return handIn(moving, sourceAtFrame(moving, frame));
}

/// A plane through a place of the hand at a frame that it comes to across, aslant of how it goes there.
StopPlane aslant(const MovingBiped& moving, double frame, const Vec3& point) {
  const Vec3 way = glm::normalize(handOfSource(moving, frame) - handOfSource(moving, frame - 1.0));
  const Vec3 aside = glm::normalize(glm::cross(way, Vec3(0.3, 1.0, 0.2)));
  return {point, way + 0.5 * aside};
}

double beyond(const StopPlane& plane, const Vec3& point) {
  return glm::dot(glm::normalize(plane.normal), point - plane.point);
}

/// The left arm twice as long where the punching biped hits, with a plane in the way of it.
struct StruckPlane {
  MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 0, strikes, 2.0);

  explicit StruckPlane(double partOfWay) {
    const Vec3 original = handOfSource(moving, strikes);
    const Vec3 stretched = handIn(moving, atFrame(moving, solved(moving, {trail}), strikes));
    trail.settings.stopAt = aslant(moving, strikes, original + partOfWay * (stretched - original));
  }
};

} // namespace

TEST_CASE("a limb that meets its stop follows it and becomes as long along it as it is to be") {
  for (const double partOfWay : {0.02, 0.3, 0.7}) {
    CAPTURE(partOfWay);
    const StruckPlane struck(partOfWay);
    const MotionState motion = solved(struck.moving, {struck.trail});
    const FrameState tip = atFrame(struck.moving, motion, strikes);
    const Limb& arm = struck.moving.limb("left-arm");
    CHECK(std::abs(beyond(*struck.trail.settings.stopAt, handIn(struck.moving, tip))) < 1e-5);
    CHECK(lengthOf(arm, tip) ==
          Approx(2.0 * lengthOf(arm, sourceAtFrame(struck.moving, strikes))).epsilon(1e-6));
  }
}

TEST_CASE("the way along a stop begins where the limb meets it, without a jump") {
  const StruckPlane struck(0.3);
  const MotionState motion = solved(struck.moving, {struck.trail});
  const MotionState freely = [&] {
    Trail trail = struck.trail;
    trail.settings.stopAt.reset();
    return solved(struck.moving, {trail});
  }();
  constexpr double step = 1.0 / 32.0;
  double farthest = 0.0;
  double farthestFree = 0.0;
  for (double frame = step; frame <= strikes; frame += step) {
    const auto way = [&](const MotionState& in) {
      return glm::length(handIn(struck.moving, atFrame(struck.moving, in, frame)) -
                         handIn(struck.moving, atFrame(struck.moving, in, frame - step)));
    };
    farthest = std::max(farthest, way(motion));
    farthestFree = std::max(farthestFree, way(freely));
  }
  CHECK(farthest > 0.0);
  CHECK(farthest < 4.0 * farthestFree);
}

TEST_CASE("a hand that rests at a stop is not taken along") {
  const MovingBiped moving = pressingBiped();
  Trail trail = connectedTrail("left-arm", 6.0, 18.0, 2.0);
  trail.settings.releaseFrames = 4.0;
  trail.settings.stopAt = aslant(moving, strikes, handOfSource(moving, strikes));
  const MotionState motion = solved(moving, {trail});
  REQUIRE_FALSE(motion.trails.front().comesToRest);
  for (double frame = strikes; frame <= 24.0; frame += 1.0) {
    CAPTURE(frame);
    CHECK(glm::length(handIn(moving, atFrame(moving, motion, frame)) - handOfSource(moving, frame)) < 1e-6);
  }
}

TEST_CASE("a hand that comes to rest on the way back touches its stop no earlier than in the clip") {
  const MovingBiped moving = pressingBiped();
  for (const double scale : {1.5, 2.0, 4.0}) {
    CAPTURE(scale);
    Trail trail = connectedTrail("left-arm", 2.0, 9.0, scale);
    trail.settings.releaseFrames = 4.0;
    trail.settings.stopAt = aslant(moving, strikes, handOfSource(moving, strikes));
    const MotionState motion = solved(moving, {trail});
    REQUIRE(motion.trails.front().comesToRest);
    double longest = 0.0;
    for (double frame = 2.0; frame < strikes - 0.25; frame += 0.25) {
      CAPTURE(frame);
      const FrameState posed = atFrame(moving, motion, frame);
      const double before = beyond(*trail.settings.stopAt, handOfSource(moving, frame));
      const double after = beyond(*trail.settings.stopAt, handIn(moving, posed));
      REQUIRE(before < 0.0);
      CHECK(after < 0.15 * before);
      longest = std::max(longest, lengthOf(moving.limb("left-arm"), posed) /
                                      lengthOf(moving.limb("left-arm"), sourceAtFrame(moving, frame)));
    }
    CHECK(longest > 1.1);
    CHECK(glm::length(handIn(moving, atFrame(moving, motion, 13.5)) - handOfSource(moving, 13.5)) < 1e-6);
  }
}

TEST_CASE("rests are where the end of a limb keeps its place, a moment's hold is none") {
  const MovingBiped moving = pressingBiped();
  const Limb& arm = moving.limb("left-arm");
  const auto restsOf = [&](const MovingBiped& biped) {
    Trail trail = connectedTrail("left-arm", 6.0, 18.0, 2.0);
    trail.settings.stopAt = StopPlane{Vec3(0.0), Vec3(0.0, 1.0, 0.0)};
    return solved(biped, {trail}).trails.front().rests.value();
  };
  const std::vector<Rest> rests = restsOf(moving);
  REQUIRE(rests.size() == 1);
  CHECK(rests[0].startSeconds == Approx(0.5));
  CHECK(rests[0].endSeconds == Approx(1.0));
  CHECK(glm::length(rests[0].place - handOfSource(moving, strikes)) < 1e-6 * arm.restLength);
  CHECK(restsOf(punchingBiped()).empty());
}

TEST_CASE(
    "rests are looked for two seconds around a range, and around a long one twice as long as it lasts") {
  MovingBiped moving = still(namedBody());
  const NodeIndex hips = moving.body.hips;
  const Vec3 start = moving.scene.nodes[at(hips)].rest.translation;
  // The body comes forward by one unit per second and stands still for a while five times.
  const std::vector<std::pair<double, double>> ways{{0.0, 0.0}, {1.0, 1.0},   {1.5, 1.0},   {2.5, 2.0},
                                                    {3.0, 2.0}, {5.75, 4.75}, {6.25, 4.75}, {7.0, 5.5},
                                                    {8.0, 5.5}, {11.0, 8.5},  {11.5, 8.5},  {12.5, 9.5}};
  VectorKeys keys;
  for (const auto& [seconds, way] : ways) {
    keys.emplace_back(seconds, start + Vec3(0.0, 0.0, way));
  }
  moving.clip.tracks.emplace_back(vectorTrack(hips, Channel::translation, Interpolation::linear, keys));
  setEndsFromKeys(moving.clip);
  const auto restsAround = [&](double startFrame, double endFrame) {
    Trail trail = connectedTrail("left-arm", startFrame, endFrame, 2.0);
    trail.settings.stopAt = StopPlane{Vec3(0.0), Vec3(0.0, 1.0, 0.0)};
    const MotionState motion = solved(moving, {trail});
    std::vector<double> starts;
    for (const Rest& rest : motion.trails.front().rests.value()) {
      starts.push_back(std::round(1000.0 * rest.startSeconds) / 1000.0);
    }
    return starts;
  };
  CHECK(restsAround(96.0, 108.0) == std::vector<double>{2.5, 5.75}); // from 2 to 6.5 seconds
  CHECK(restsAround(48.0, 144.0) == std::vector<double>{1.0, 2.5, 5.75, 7.0, 11.0});
}

TEST_CASE("a limb that keeps its place for four frames of 24 a second rests, for three it does not") {
  MovingBiped moving = still(namedBody());
  const Vec3 start = moving.scene.nodes[at(moving.body.hips)].rest.translation;
  VectorKeys keys;
  for (const auto& [frame, way] :
       {std::pair(0.0, 0.0), {24.0, 1.0}, {28.0, 1.0}, {48.0, 1.8}, {51.0, 1.8}, {72.0, 2.7}}) {
    keys.emplace_back(frame / 24.0, start + Vec3(0.0, 0.0, way));
  }
  moving.clip.tracks.emplace_back(
      vectorTrack(moving.body.hips, Channel::translation, Interpolation::linear, keys));
  setEndsFromKeys(moving.clip);
  Trail trail = connectedTrail("left-arm", 30.0, 50.0, 2.0);
  trail.settings.stopAt = StopPlane{Vec3(0.0), Vec3(0.0, 1.0, 0.0)};
  const MotionState motion = solved(moving, {trail});
  const std::vector<Rest>& rests = motion.trails.front().rests.value();
  REQUIRE(rests.size() == 1);
  CHECK(rests[0].startSeconds == Approx(1.0));
  CHECK(rests[0].endSeconds == Approx(28.0 / 24.0));
}

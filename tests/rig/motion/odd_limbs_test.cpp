#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/limb.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// The left foot hangs on the root with keys of its own, as feet driven by IK are when they were baked.
MovingBiped withDetachedFoot() {
  MovingBiped moving = punchingBiped();
  const NodeIndex foot = moving.node.at("foot.l");
  const NodeIndex shin = moving.node.at("shin.l");
  const NodeIndex root = moving.node.at("root");
  VectorKeys places;
  for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
    const FrameState state = sourceAtFrame(moving, frame);
    const Mat4 inRoot = glm::inverse(state.worlds[at(root)]) * state.worlds[at(foot)];
    places.emplace_back(frame / 24.0, positionOf(inRoot));
  }
  std::erase(moving.scene.nodes[at(shin)].children, foot);
  moving.scene.nodes[at(root)].children.push_back(foot);
  moving.scene.nodes[at(foot)].parent = root;
  moving.clip.tracks.emplace_back(vectorTrack(foot, Channel::translation, Interpolation::linear, places));
  for (Limb& limb : moving.body.limbs) {
    if (limb.id == "left-leg") {
      REQUIRE(limb.endNode == foot);
    }
  }
  return moving;
}

} // namespace

TEST_CASE("a foot under the root follows the leg through its own channels") {
  const MovingBiped moving = withDetachedFoot();
  const Limb& leg = moving.limb("left-leg");
  const auto foot = at(moving.node.at("foot.l"));
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    Trail trail = connectedTrail("left-leg", 0, 12, 2.0);
    trail.settings.bend = bend;
    const MotionState motion = solved(moving, {trail});
    REQUIRE_FALSE(motion.trails.front().topology.endIsDescendant);
    const FrameState before = sourceAtFrame(moving, 12);
    const FrameState after = atFrame(moving, motion, 12);
    CHECK(lengthOf(leg, after) == Approx(2.0 * lengthOf(leg, before)).epsilon(1e-4));
    CHECK(std::abs(glm::dot(rotationOf(after.worlds[foot]), rotationOf(before.worlds[foot]))) ==
          Approx(1.0).margin(1e-9));
    const Rekeyed rekeyed = rekeyedOf(moving, {trail});
    CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
    const bool hasFoot = std::ranges::any_of(rekeyed.keys.tracks, [&](const Track& track) {
      return track.node == moving.node.at("foot.l") && track.channel == Channel::translation;
    });
    CHECK(hasFoot);
  }
}

TEST_CASE("a foot under the root stays where it is while the hips go down, and its leg reaches it") {
  const MovingBiped moving = withDetachedFoot();
  const Limb& leg = moving.limb("left-leg");
  const Rekeyed rekeyed = rekeyedOf(moving, {moved("hips", {0.0, -0.15, 0.0})});
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState keyed = poseOf(moving, rekeyed.clip, frame);
    CHECK(glm::length(endPosition(leg, keyed) - endPosition(leg, source)) < 1e-4 * moving.body.height);
    const std::vector<Vec3> bones = limbPoints(leg, keyed);
    const std::vector<Vec3> before = limbPoints(leg, source);
    CHECK(std::abs(glm::length(bones[2] - bones[1]) - glm::length(before[2] - before[1])) < 1e-3);
    CHECK(glm::length(bones[1] - before[1]) > 0.01);
  }
  const Rekeyed lifted = rekeyedOf(moving, {moved("left-foot", {0.0, 0.2, 0.0})});
  CHECK(worstMiss(moving, lifted, 0, 24) < 1e-4 * moving.body.height);
  CHECK(endPosition(leg, poseOf(moving, lifted.clip, 0.0)).y >
        endPosition(leg, sourceAtFrame(moving, 0.0)).y + 0.15);
}

TEST_CASE("a hand without a joint is put where it is asked to be by its estimated end") {
  const MovingBiped moving = still(namedBody({.hands = false}));
  const Limb& arm = moving.limb("right-arm");
  const Vec3 move(0.1, -0.1, 0.1);
  const FrameState source = sourceAtFrame(moving, 0.0);
  const FrameState frame = atFrame(moving, adjusted(moving, {moved("right-hand", move)}), 0.0);
  REQUIRE(arm.endNode == NodeIndex::none);
  CHECK(glm::length(endPosition(arm, frame) - endPosition(arm, source) - move) < 1e-6);
}

TEST_CASE("a limb without an end joint is stretched to its estimated end") {
  MovingBiped moving = still(namedBody({.hands = false}));
  const Limb& arm = moving.limb("left-arm");
  REQUIRE(arm.endNode == NodeIndex::none);
  RotationKeys keys{{0.0, axisAngle(Vec3(0, 1, 0), 1.0)},
                    {0.5, axisAngle(Vec3(0, 1, 0), -1.2)},
                    {1.0, axisAngle(Vec3(0, 1, 0), 1.0)}};
  moving.clip.tracks.emplace_back(rotationTrack(moving.node.at("upperArm.l"), Interpolation::linear, keys));
  moving.clip.endSeconds = 1.0;
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(limbLength(arm, atFrame(moving, motion, 12)) ==
        Approx(2.0 * limbLength(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  CHECK(worstMiss(moving, rekeyedOf(moving, {connectedTrail("left-arm", 0, 12, 2.0)}), 0, 24) <
        1e-4 * moving.body.height);
}

TEST_CASE("a stretched spine leaves the legs where they are, even where they hang on its first joint") {
  SyntheticBiped body = namedBody();
  MovingBiped moving = still(body);
  addPunch(moving, Interpolation::linear);
  Limb& spine = *std::ranges::find(moving.body.limbs, std::string("spine"), &Limb::id);
  spine.joints = {moving.node.at("hips"), moving.node.at("spine0"), moving.node.at("spine1")};
  const MotionState motion = solved(moving, {connectedTrail("spine", 0, 12, 1.5)});
  for (const double frame : {3.0, 12.0, 15.0}) {
    const FrameState before = sourceAtFrame(moving, frame);
    const FrameState after = atFrame(moving, motion, frame);
    for (const std::string key : {"thigh.l", "shin.l", "foot.l", "toe.l", "thigh.r", "foot.r"}) {
      const auto node = at(moving.node.at(key));
      CAPTURE(frame, key);
      CHECK(glm::length(positionOf(after.worlds[node]) - positionOf(before.worlds[node])) < 1e-9);
      CHECK(std::abs(glm::dot(rotationOf(after.worlds[node]), rotationOf(before.worlds[node]))) ==
            Approx(1.0).margin(1e-9));
    }
  }
  CHECK(lengthOf(spine, atFrame(moving, motion, 12)) ==
        Approx(1.5 * lengthOf(spine, sourceAtFrame(moving, 12))).epsilon(1e-4));
}

TEST_CASE("a node that the file gives as a matrix can be re-keyed") {
  MovingBiped moving = punchingBiped();
  const NodeIndex foreArm = moving.node.at("foreArm.l");
  Node& node = moving.scene.nodes[at(foreArm)];
  node.matrix = toMatrix(node.rest);
  std::erase_if(moving.clip.tracks, [&](const CopyOnWrite<Track>& track) { return track->node == foreArm; });
  const std::vector<Trail> trails{connectedTrail("left-arm", 0, 12, 2.0)};
  CHECK(worstMiss(moving, rekeyedOf(moving, trails), 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("a trail on a clip without keys changes nothing and says why") {
  MovingBiped moving = still(namedBody());
  moving.clip.endSeconds = 1.0;
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(motion.trails.front().tip.outcome == TipOutcome::nothingToScale);
  REQUIRE(motion.trails.front().warnings.size() == 1);
  CHECK(largestMatrixMiss(atFrame(moving, motion, 12), sourceAtFrame(moving, 12)) == 0.0);
  CHECK(rekeyedOf(moving, {connectedTrail("left-arm", 0, 12, 2.0)}).keys.tracks.empty());
}

TEST_CASE("a trail whose limb is missing is left out") {
  const MovingBiped moving = punchingBiped();
  CHECK(solved(moving, {connectedTrail("tail", 0, 12, 2.0)}).trails.empty());
}

TEST_CASE("ranges are clamped to the clip") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, {connectedTrail("left-arm", -5, 500, 2.0)});
  CHECK(motion.trails.front().settings.startFrame == 0.0);
  CHECK(motion.trails.front().settings.endFrame == Approx(24.0));
  for (const double frame : {-3.0, 0.0, 24.0, 30.0}) {
    CHECK(std::isfinite(glm::length(positionOf(atFrame(moving, motion, frame).worlds.back()))));
  }
}

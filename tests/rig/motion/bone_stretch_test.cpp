#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "rig/reach/limb_deform.h"
#include "rig/rekey/stretch_frames.h"
#include "tests/support/matrices.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

Mat3 stretchOfNode(const FrameState& frame, NodeIndex node) {
  return frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(node)];
}

} // namespace

TEST_CASE("a bone's stretch lengthens it along its axis and preserves as much volume as asked") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = glm::normalize(Vec3(number(random), number(random), number(random)) + Vec3(1e-3));
    const double s = std::exp(2.0 * number(random));
    const Mat3 full = boneStretch(axis, s, 1.0);
    CHECK(glm::determinant(full) == Approx(1.0).margin(1e-6));
    CHECK(glm::length(full * axis - s * axis) < 1e-12 * (1.0 + s));
    const Vec3 across = anyPerpendicular(axis);
    CHECK(glm::length(full * across) == Approx(1.0 / std::sqrt(s)));
    const Mat3 none = boneStretch(axis, s, 0.0);
    CHECK(glm::length(none * across) == Approx(1.0));
    CHECK(glm::determinant(none) == Approx(s));
  }
}

TEST_CASE("axis and factors of a stretch are found again from its matrix") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 axis = glm::normalize(Vec3(number(random), number(random), number(random)) + Vec3(1e-3));
    const double s = std::exp(3.0 * number(random));
    const double volume = std::abs(number(random));
    const Mat3 stretch = boneStretch(axis, s, volume);
    const StretchFrame frame = mainFrame(stretch);
    CAPTURE(s, volume);
    CHECK(frame.factors.x == Approx(s).epsilon(1e-6));
    CHECK(frame.factors.y == Approx(std::pow(s, -0.5 * volume)).epsilon(1e-6));
    CHECK(frame.factors.z == Approx(frame.factors.y).epsilon(1e-6));
    if (std::abs(frame.factors.x - frame.factors.y) > 1e-3) {
      CHECK(std::abs(glm::dot(frame.axes * Vec3(1, 0, 0), axis)) == Approx(1.0).margin(1e-6));
    }
    CHECK(largestDifference(frame.matrix(), stretch) < 1e-6);
  }
  CHECK(mainFrame(Mat3(1.0)).factors == Vec3(1.0));
}

TEST_CASE("every bone of a stretched limb carries K of the limb's stretch, hand and fingers none") {
  const MovingBiped moving = punchingBiped();
  for (const double volume : {0.0, 0.5, 1.0}) {
    Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
    trail.settings.volume = volume;
    const MotionState motion = solved(moving, {trail});
    for (double frame = 0.0; frame <= 18.0; frame += 1.5) {
      const FrameState before = sourceAtFrame(moving, frame);
      const FrameState after = atFrame(moving, motion, frame);
      const Limb& arm = moving.limb("left-arm");
      const double s = lengthOf(arm, after) / lengthOf(arm, before);
      CAPTURE(volume, frame, s);
      for (const std::string key : {"upperArm.l", "foreArm.l"}) {
        const Mat3 k = stretchOfNode(after, moving.node.at(key));
        CHECK(glm::determinant(k) == Approx(std::pow(s, 1.0 - volume)).epsilon(1e-6));
        CHECK(largestDifference(k, glm::transpose(k)) < 1e-12);
      }
      for (const std::string key : {"hand.l", "finger0a.l", "clavicle.l", "upperArm.r", "hips", "thigh.l"}) {
        CHECK(largestDifference(stretchOfNode(after, moving.node.at(key)), Mat3(1.0)) == 0.0);
      }
    }
  }
}

TEST_CASE("scale of the nodes themselves never changes, nor the size of what hangs on the limb") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 3.0)});
  const FrameState before = sourceAtFrame(moving, 12);
  const FrameState after = atFrame(moving, motion, 12);
  for (std::size_t node = 0; node < after.worlds.size(); ++node) {
    CHECK(glm::length(after.pose.locals[node].scale - before.pose.locals[node].scale) < 1e-12);
    CHECK(glm::determinant(Mat3(after.worlds[node])) == Approx(glm::determinant(Mat3(before.worlds[node]))));
  }
  const auto hand = at(moving.node.at("hand.l"));
  const auto finger = at(moving.node.at("finger1b.l"));
  const double span = glm::length(positionOf(before.worlds[finger]) - positionOf(before.worlds[hand]));
  CHECK(glm::length(positionOf(after.worlds[finger]) - positionOf(after.worlds[hand])) == Approx(span));
}

TEST_CASE("twist joints beside and in the chain ride on their bone and carry its stretch") {
  for (const bool inChain : {false, true}) {
    SyntheticBiped body = namedBody();
    addTwist(body, "twist.l", "upperArm.l", "foreArm.l", 0.5, inChain);
    MovingBiped moving = still(body);
    REQUIRE(moving.limb("left-arm").joints ==
            std::vector{moving.node.at("upperArm.l"), moving.node.at("foreArm.l")});
    addPunch(moving, Interpolation::linear);
    const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
    const FrameState after = atFrame(moving, motion, 12);
    const auto place = [&](const std::string& key) {
      return positionOf(after.worlds[at(moving.node.at(key))]);
    };
    CAPTURE(inChain);
    CHECK(glm::length(place("twist.l") - 0.5 * (place("upperArm.l") + place("foreArm.l"))) < 1e-9);
    CHECK(lengthOf(moving.limb("left-arm"), after) ==
          Approx(2.0 * lengthOf(moving.limb("left-arm"), sourceAtFrame(moving, 12))).epsilon(1e-4));
    // The same deformation in the world as the bone's own.
    const auto inWorld = [&](const std::string& key) {
      const auto node = at(moving.node.at(key));
      const Mat3 world = Mat3(after.worlds[node]);
      return world * stretchOfNode(after, moving.node.at(key)) * glm::inverse(world);
    };
    CHECK(largestDifference(inWorld("twist.l"), inWorld("upperArm.l")) < 1e-9);
  }
}

TEST_CASE("a helper node between two joints that is no joint takes the stretch on") {
  SyntheticBiped body = namedBody();
  addTwist(body, "helper.l", "foreArm.l", "hand.l", 0.4, true);
  body.joints.back().isJoint = false;
  MovingBiped moving = still(body);
  // Turned and scaled, as helpers of exporters are.
  Node& helper = moving.scene.nodes[at(moving.node.at("helper.l"))];
  Node& hand = moving.scene.nodes[at(moving.node.at("hand.l"))];
  helper.rest.rotation = axisAngle(glm::normalize(Vec3(1, 2, -1)), 1.1);
  helper.rest.scale = Vec3(2.0);
  hand.rest.translation = glm::inverse(helper.rest.rotation) * hand.rest.translation * 0.5;
  hand.rest.scale = Vec3(0.5);
  addPunch(moving, Interpolation::linear);
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    Trail trail = connectedTrail("left-arm", 0, 12, 2.5);
    trail.settings.bend = bend;
    const MotionState motion = solved(moving, {trail});
    const Limb& arm = moving.limb("left-arm");
    CHECK(lengthOf(arm, atFrame(moving, motion, 12)) ==
          Approx(2.5 * lengthOf(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  }
}

TEST_CASE("a limb under a mirrored parent behaves as any other") {
  MovingBiped moving = punchingBiped();
  Node& armature = moving.scene.nodes[0];
  armature.rest.scale = Vec3(-1.0, 1.0, 1.0) * 0.5;
  moving.body.height *= 0.5;
  for (Limb& limb : moving.body.limbs) {
    limb.restLength *= 0.5;
  }
  const Limb& arm = moving.limb("left-arm");
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(lengthOf(arm, atFrame(moving, motion, 12)) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  // Close to the pivot the change is small everywhere: no orientation flips.
  CHECK(largestMatrixMiss(atFrame(moving, motion, 0.01), sourceAtFrame(moving, 0.01)) < 0.01);
}

TEST_CASE("joints scaled to nothing leave the motion finite") {
  for (const std::string key : {"upperArm.l", "foreArm.l", "hand.l", "clavicle.l"}) {
    MovingBiped moving = punchingBiped();
    moving.scene.nodes[at(moving.node.at(key))].rest.scale = Vec3(0.0);
    const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
    for (double frame = 0.0; frame <= 24.0; frame += 3.0) {
      const FrameState after = atFrame(moving, motion, frame);
      for (std::size_t node = 0; node < after.worlds.size(); ++node) {
        const Mat4 mesh = meshMatrix(after, NodeIndex(node));
        CAPTURE(key, frame, node);
        REQUIRE(std::isfinite(glm::determinant(mesh)));
        REQUIRE(std::isfinite(glm::length(positionOf(mesh))));
      }
    }
  }
}

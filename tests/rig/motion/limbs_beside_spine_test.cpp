#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rig/limb.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const std::vector<std::string> upperKeys{"upperArm.l", "foreArm.l", "hand.l", "upperArm.r",
                                         "foreArm.r",  "hand.r",    "neck0",  "head"};

/// Hangs a joint of a body that stands still on another node, where it is.
void hang(MovingBiped& moving, const std::string& key, NodeIndex parent) {
  const FrameState still = sourceAtFrame(moving, 0.0);
  const NodeIndex node = moving.node.at(key);
  Node& joint = moving.scene.nodes[at(node)];
  std::erase(moving.scene.nodes[at(joint.parent)].children, node);
  moving.scene.nodes[at(parent)].children.push_back(node);
  joint.parent = parent;
  joint.rest.translation = positionOf(glm::inverse(still.worlds[at(parent)]) * still.worlds[at(node)]);
}

/// Arms and neck hang beside the spine on the hips, as boxes that were parented side by side.
MovingBiped boxesSideBySide() {
  MovingBiped moving = still(namedBody({.clavicles = false}));
  for (const char* key : {"upperArm.l", "upperArm.r", "neck0"}) {
    hang(moving, key, moving.node.at("hips"));
  }
  addPunch(moving, Interpolation::linear);
  return moving;
}

/// The deforming joints of the trunk hang by themselves, and all others on masters.
MovingBiped deformingBesideMasters() {
  MovingBiped moving = still(namedBody());
  const NodeIndex torso = addNode(moving.scene, "torso", moving.node.at("root"), Vec3(0.0, 1.1, 0.0));
  const NodeIndex chest = addNode(moving.scene, "chest", torso, Vec3(0.0, 0.1, 0.0));
  for (const char* key : {"clavicle.l", "clavicle.r", "neck0"}) {
    hang(moving, key, chest);
  }
  for (const char* key : {"thigh.l", "thigh.r"}) {
    hang(moving, key, torso);
  }
  addPunch(moving, Interpolation::linear);
  return moving;
}

std::vector<MovingBiped> besideTheSpine() {
  return {boxesSideBySide(), deformingBesideMasters()};
}

Mat4 worldOf(const MovingBiped& moving, const FrameState& frame, const std::string& key) {
  return frame.worlds[at(moving.node.at(key))];
}

Vec3 placeOf(const MovingBiped& moving, const FrameState& frame, const std::string& key) {
  return positionOf(worldOf(moving, frame, key));
}

/// How far a joint is from where it stood beside another in the clip, which has moved since.
double tornOff(const MovingBiped& moving, const FrameState& source, const FrameState& frame,
               const std::string& key, const std::string& from) {
  const Vec3 beside =
      transformPoint(glm::inverse(worldOf(moving, source, from)), placeOf(moving, source, key));
  return glm::length(transformPoint(worldOf(moving, frame, from), beside) - placeOf(moving, frame, key));
}

} // namespace

TEST_CASE("arms, neck and head that hang beside a stretched spine go with its end, legs stay") {
  for (const MovingBiped& moving : besideTheSpine()) {
    const Rekeyed rekeyed = rekeyedOf(moving, {connectedTrail("spine", 0, 12, 1.6)});
    const FrameState source = sourceAtFrame(moving, 12);
    const FrameState frame = atFrame(moving, rekeyed.motion, 12);
    REQUIRE(glm::length(placeOf(moving, frame, "spine2") - placeOf(moving, source, "spine2")) > 0.1);
    for (const std::string& key : upperKeys) {
      CAPTURE(key);
      CHECK(tornOff(moving, source, frame, key, "spine2") < 1e-9);
    }
    for (const std::string key : {"thigh.l", "foot.l", "thigh.r", "foot.r"}) {
      CAPTURE(key);
      CHECK(glm::length(placeOf(moving, frame, key) - placeOf(moving, source, key)) < 1e-9);
    }
    CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  }
}

TEST_CASE("an arm beside a stretched spine turns with it under a trail of its own, and holds its length") {
  for (const MovingBiped& moving : besideTheSpine()) {
    Trail arm = connectedTrail("left-arm", 6, 12, 2.0);
    arm.id = 2;
    std::vector<Trail> both{connectedTrail("spine", 0, 12, 1.6), arm};
    both.front().settings.turnEnd = true;
    const MotionState motion = solved(moving, both);
    const FrameState source = sourceAtFrame(moving, 12);
    CHECK(lengthOf(moving.limb("left-arm"), atFrame(moving, motion, 12)) ==
          Approx(2.0 * lengthOf(moving.limb("left-arm"), source)).epsilon(1e-4));
    const DrawnTrail drawn = pathsAt(moving.scene, moving.clip, motion, 1, {12.0});
    CHECK(glm::distance(drawn.exaggerated.front(), placeOf(moving, atFrame(moving, motion, 12), "hand.l")) <
          1e-4);
    // Where its own trail begins, nothing jumps.
    const MotionState spineAlone = solved(moving, {both.front()});
    CHECK(glm::length(placeOf(moving, atFrame(moving, motion, 6), "hand.l") -
                      placeOf(moving, atFrame(moving, spineAlone, 6), "hand.l")) < 1e-6);
    CHECK(worstMiss(moving, rekeyedOf(moving, both), 0, 24) < 1e-4 * moving.body.height);
  }
}

TEST_CASE("the path of a pinned arm beside a stretched spine is drawn where its hand comes to be") {
  for (const MovingBiped& moving : besideTheSpine()) {
    Trail arm = connectedTrail("left-arm", 6, 12, 2.0);
    arm.id = 2;
    Holds holds;
    holds.pins = {pinAt("left-arm", heldOver(12, 14, 8, 0), 12)};
    const MotionState motion = held(motionInput(moving, {connectedTrail("spine", 0, 12, 1.6), arm}), holds);
    for (const double frame : {7.0, 9.0, 12.0}) {
      CAPTURE(frame);
      const DrawnTrail drawn = pathsAt(moving.scene, moving.clip, motion, 1, {frame});
      CHECK(glm::distance(drawn.exaggerated.front(),
                          placeOf(moving, atFrame(moving, motion, frame), "hand.l")) < 1e-4);
    }
  }
}

TEST_CASE("arms and neck that hang beside the spine go along where its top is posed") {
  for (const MovingBiped& moving : besideTheSpine()) {
    Adjustment top = moved("spine-top", {0.05, 0.2, 0.0});
    top.keys.front().turn = {0.2, 0.4, 0.0};
    const Rekeyed rekeyed = rekeyedOf(moving, {top});
    for (double frame = 0.0; frame <= 24.0; frame += 3.0) {
      const FrameState source = sourceAtFrame(moving, frame);
      const FrameState posed = atFrame(moving, rekeyed.motion, frame);
      REQUIRE(glm::length(placeOf(moving, posed, "spine2") - placeOf(moving, source, "spine2")) > 0.1);
      for (const std::string& key : upperKeys) {
        CAPTURE(frame, key);
        CHECK(tornOff(moving, source, posed, key, "spine2") < 1e-6);
      }
    }
    CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  }
}

TEST_CASE("a leg of boxes that hang side by side on the root goes along with the hips as one") {
  MovingBiped moving = still(namedBody());
  for (const char* key : {"foot.l", "shin.l", "thigh.l"}) {
    hang(moving, key, moving.node.at("root"));
  }
  addPunch(moving, Interpolation::linear);
  const Rekeyed rekeyed = rekeyedOf(moving, {moved("hips", {0.0, -0.1, 0.0})});
  const FrameState source = sourceAtFrame(moving, 0);
  const FrameState posed = atFrame(moving, rekeyed.motion, 0);
  const auto bone = [&](const FrameState& frame, const std::string& from, const std::string& to) {
    return glm::distance(placeOf(moving, frame, from), placeOf(moving, frame, to));
  };
  CHECK(tornOff(moving, source, posed, "thigh.l", "hips") < 1e-9);
  CHECK(bone(posed, "thigh.l", "shin.l") == Approx(bone(source, "thigh.l", "shin.l")).epsilon(1e-3));
  CHECK(bone(posed, "shin.l", "foot.l") == Approx(bone(source, "shin.l", "foot.l")).epsilon(1e-3));
  CHECK(glm::distance(placeOf(moving, posed, "foot.l"), placeOf(moving, source, "foot.l")) < 1e-6);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("limbs that hang beside the hips go along where these are posed, and the feet stay") {
  const MovingBiped moving = deformingBesideMasters();
  REQUIRE(moving.body.hips == moving.node.at("hips"));
  Adjustment hips = moved("hips", {0.05, -0.1, 0.0});
  hips.keys.front().turn = {0.0, 0.3, 0.0};
  const Rekeyed rekeyed = rekeyedOf(moving, {hips});
  for (double frame = 0.0; frame <= 24.0; frame += 3.0) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState posed = atFrame(moving, rekeyed.motion, frame);
    CHECK(glm::length(placeOf(moving, posed, "hips") - placeOf(moving, source, "hips")) > 0.1);
    CHECK(tornOff(moving, source, posed, "thigh.l", "hips") < 1e-9);
    CHECK(tornOff(moving, source, posed, "thigh.r", "hips") < 1e-9);
    for (const std::string& key : upperKeys) {
      CAPTURE(frame, key);
      CHECK(tornOff(moving, source, posed, key, "hips") < 1e-6);
    }
    for (const std::string key : {"foot.l", "foot.r"}) {
      CHECK(glm::length(placeOf(moving, posed, key) - placeOf(moving, source, key)) < 1e-6);
    }
  }
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

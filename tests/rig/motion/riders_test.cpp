#include <algorithm>
#include <string>
#include <tuple>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/reach/limb_topology.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// A box of rigid mesh as a node under a joint; corners in the bind pose's world.
NodeIndex hangBox(Scene& scene, NodeIndex parent, const Vec3& low, const Vec3& high,
                  const Quat& turn = {1.0, 0.0, 0.0, 0.0}, double size = 1.0) {
  const Mat4 above = bindPoseWorlds(scene)[at(parent)];
  const Vec3 middle = 0.5 * (low + high);
  const NodeIndex box = addNode(scene, "part", parent, transformPoint(glm::inverse(above), middle));
  scene.nodes[at(box)].rest.rotation = turn;
  scene.nodes[at(box)].rest.scale = Vec3(size);
  const Mat4 world = bindPoseWorlds(scene)[at(box)];
  Primitive primitive;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                     (corner & 4) != 0 ? high.z : low.z);
    primitive.positions.emplace_back(transformPoint(glm::inverse(world), point));
  }
  scene.nodes[at(box)].mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back({"box", {primitive}, {}});
  return box;
}

// The corners of a box as a frame shows them.
std::vector<Vec3> cornersOf(const MovingBiped& moving, NodeIndex box, const FrameState& frame) {
  std::vector<Vec3> corners;
  const int mesh = moving.scene.nodes[at(box)].mesh;
  for (const glm::vec3& position :
       moving.scene.meshes[static_cast<std::size_t>(mesh)].primitives[0].positions) {
    corners.push_back(transformPoint(meshMatrix(frame, box), Vec3(position)));
  }
  return corners;
}

// How far corners are from where the joint with its stretch would take them as vertices of its own.
double missOfBone(const MovingBiped& moving, NodeIndex box, const std::string& joint,
                  const FrameState& frame) {
  const std::vector<Mat4> bind = bindPoseWorlds(moving.scene);
  const NodeIndex node = moving.node.at(joint);
  const Mat4 carried = meshMatrix(frame, node) * glm::inverse(bind[at(node)]) * bind[at(box)];
  const int mesh = moving.scene.nodes[at(box)].mesh;
  const std::vector<Vec3> corners = cornersOf(moving, box, frame);
  double miss = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 point(moving.scene.meshes[static_cast<std::size_t>(mesh)].primitives[0].positions[i]);
    miss = std::max(miss, glm::distance(corners[i], transformPoint(carried, point)));
  }
  return miss;
}

MovingBiped withBox(const std::string& joint, const Vec3& low, const Vec3& high, NodeIndex& box,
                    const Quat& turn = {1.0, 0.0, 0.0, 0.0}, double size = 1.0) {
  MovingBiped moving = still(namedBody());
  box = hangBox(moving.scene, moving.node.at(joint), low, high, turn, size);
  addPunch(moving, Interpolation::linear);
  return moving;
}

// That a node moves with the end of a limb as one piece.
void checkGoesWithEnd(const MovingBiped& moving, const MotionState& motion, const std::string& key,
                      NodeIndex end) {
  const auto node = at(moving.node.at(key));
  for (const double frame : {4.0, 8.0, 12.0, 15.0}) {
    const FrameState before = sourceAtFrame(moving, frame);
    const FrameState after = atFrame(moving, motion, frame);
    const Mat4 seenBefore = glm::inverse(before.worlds[at(end)]) * before.worlds[node];
    const Mat4 seenAfter = glm::inverse(after.worlds[at(end)]) * after.worlds[node];
    CAPTURE(key, frame);
    for (int column = 0; column < 4; ++column) {
      CHECK(glm::length(seenAfter[column] - seenBefore[column]) < 1e-9);
    }
  }
}

} // namespace

TEST_CASE("a rigid mesh on a joint of a limb is stretched with its bone, however it is turned") {
  NodeIndex box;
  const Quat turn = GENERATE(Quat(1.0, 0.0, 0.0, 0.0), axisAngle(glm::normalize(Vec3(1, 2, -1)), 1.1));
  const double size = GENERATE(1.0, 0.01);
  const MovingBiped moving =
      withBox("upperArm.l", Vec3(0.18, 1.38, -0.06), Vec3(0.45, 1.48, 0.02), box, turn, size);
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  for (const double frame : {3.0, 8.0, 12.0, 15.0}) {
    CAPTURE(frame);
    CHECK(missOfBone(moving, box, "upperArm.l", atFrame(moving, motion, frame)) < 1e-9);
  }
  const Rekeyed rekeyed = rekeyedOf(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
  CHECK(
      std::ranges::any_of(rekeyed.keys.stretches, [&](const StretchKeys& keys) { return keys.node == box; }));
}

TEST_CASE("a rigid mesh in a group under a joint is stretched with the bone") {
  MovingBiped moving = still(namedBody());
  const NodeIndex group = addNode(moving.scene, "group", moving.node.at("foreArm.l"), Vec3(0.05, 0.02, 0.0));
  const NodeIndex box = hangBox(moving.scene, group, Vec3(0.47, 1.38, -0.06), Vec3(0.68, 1.48, 0.02));
  addPunch(moving, Interpolation::linear);
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  CHECK(missOfBone(moving, box, "foreArm.l", atFrame(moving, motion, 12)) < 1e-9);
}

TEST_CASE("what a limb holds keeps its size and moves with the bone") {
  NodeIndex box;
  const MovingBiped moving = withBox("foreArm.l", Vec3(0.5, 1.1, -0.1), Vec3(0.55, 2.6, 0.1), box);
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  const std::vector<Vec3> before = cornersOf(moving, box, sourceAtFrame(moving, 12));
  const std::vector<Vec3> after = cornersOf(moving, box, atFrame(moving, motion, 12));
  CHECK(glm::distance(after[0], after[7]) == Approx(glm::distance(before[0], before[7])));
  CHECK(glm::distance(after[0], before[0]) > 0.1);
}

TEST_CASE("a heel beside the foot goes with it, and so does a foot under the root beside a heel") {
  SyntheticBiped body = namedBody();
  SECTION("both under the shin") {
    body.joints.push_back({"heel.l", "shin.l", Vec3(0.1, 0.08, -0.05)});
  }
  SECTION("the heel under the root") {
    body.joints.push_back({"heel.l", "root", Vec3(0.1, 0.06, -0.06)});
  }
  SECTION("the heel carries the foot, both under the root") {
    body.joints.push_back({"heel.l", "root", Vec3(0.1, 0.06, -0.06)});
    for (SyntheticJoint& joint : body.joints) {
      joint.parent = joint.key == "foot.l" ? "heel.l" : joint.parent;
    }
  }
  body.names["heel.l"] = "mixamorig:LeftHeel";
  MovingBiped moving = still(body);
  addPunch(moving, Interpolation::linear);
  const NodeIndex heel = moving.node.at("heel.l");
  if (isAncestorOrSelf(moving.scene, heel, moving.node.at("foot.l"))) {
    const Vec3 rest = moving.scene.nodes[at(heel)].rest.translation;
    const VectorKeys kick{{0.0, rest}, {0.5, rest + Vec3(0.0, 0.3, 0.5)}, {1.0, rest}};
    moving.clip.tracks.emplace_back(vectorTrack(heel, Channel::translation, Interpolation::linear, kick));
  }
  const Limb& leg = moving.limb("left-leg");
  REQUIRE(leg.endNode == moving.node.at("foot.l"));
  const MotionState motion = solved(moving, {connectedTrail("left-leg", 0, 12, 2.0)});
  checkGoesWithEnd(moving, motion, "heel.l", leg.endNode);
  CHECK(worstMiss(moving, rekeyedOf(moving, {connectedTrail("left-leg", 0, 12, 2.0)}), 0, 24) <
        1e-4 * moving.body.height);
  const FrameState after = atFrame(moving, motion, 12);
  const FrameState before = sourceAtFrame(moving, 12);
  CHECK(lengthOf(leg, after) == Approx(2.0 * lengthOf(leg, before)).epsilon(1e-4));
  for (const std::string key : {"foot.r", "hand.l", "hips"}) {
    CAPTURE(key);
    const auto node = at(moving.node.at(key));
    CHECK(glm::distance(positionOf(after.worlds[node]), positionOf(before.worlds[node])) < 1e-9);
  }
}

TEST_CASE("a skirt beside the hand stays on the body") {
  SyntheticBiped body = namedBody();
  body.joints.push_back({"skirt.l", "hips", Vec3(0.66, 1.4, 0.0)});
  body.names["skirt.l"] = "skirt_l";
  MovingBiped moving = still(body);
  addPunch(moving, Interpolation::linear);
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, 2.0)});
  const auto skirt = at(moving.node.at("skirt.l"));
  CHECK(glm::distance(positionOf(atFrame(moving, motion, 12).worlds[skirt]),
                      positionOf(sourceAtFrame(moving, 12).worlds[skirt])) < 1e-12);
}

TEST_CASE(
    "deforming joints under masters, as whole rigs are exported, stretch as one limb, fingers included") {
  SyntheticBiped body = namedBody();
  std::string above = "clavicle.l";
  for (const std::string key : {"upperArm.l", "foreArm.l", "hand.l"}) {
    SyntheticJoint& joint = *std::ranges::find(body.joints, key, &SyntheticJoint::key);
    const std::string master = "org." + key;
    joint.parent = master;
    const Vec3 place = joint.position;
    body.joints.push_back({master, above, place, false, false});
    body.names[master] = "ORG-" + key;
    above = master;
  }
  for (SyntheticJoint& joint : body.joints) {
    joint.parent = joint.parent == "hand.l" ? "org.hand.l" : joint.parent;
  }
  MovingBiped moving = still(body);
  const Limb& arm = moving.limb("left-arm");
  REQUIRE(arm.joints == std::vector{moving.node.at("upperArm.l"), moving.node.at("foreArm.l")});
  REQUIRE(arm.endNode == moving.node.at("hand.l"));
  for (const auto& [key, degrees] : {std::pair("org.upperArm.l", 70.0), std::pair("org.foreArm.l", 50.0)}) {
    const RotationKeys keys{{0.0, axisAngle(Vec3(0, 1, 0), degrees * pi / 180.0)},
                            {0.5, axisAngle(Vec3(0, 1, 0), -degrees * pi / 180.0)},
                            {1.0, axisAngle(Vec3(0, 1, 0), 0.0)}};
    moving.clip.tracks.emplace_back(rotationTrack(moving.node.at(key), Interpolation::linear, keys));
  }
  moving.clip.endSeconds = 1.0;
  const std::vector<Trail> trails{connectedTrail("left-arm", 0, 12, 2.0)};
  const MotionState motion = solved(moving, trails);
  for (const double frame : {6.0, 12.0, 15.0}) {
    CAPTURE(frame);
    const FrameState before = sourceAtFrame(moving, frame);
    const FrameState after = atFrame(moving, motion, frame);
    const auto bone = [&](const FrameState& state, const std::string& from, const std::string& to) {
      return glm::distance(positionOf(state.worlds[at(moving.node.at(from))]),
                           positionOf(state.worlds[at(moving.node.at(to))]));
    };
    const double s = lengthOf(arm, after) / lengthOf(arm, before);
    CHECK(bone(after, "upperArm.l", "foreArm.l") ==
          Approx(s * bone(before, "upperArm.l", "foreArm.l")).epsilon(1e-6));
    CHECK(bone(after, "foreArm.l", "hand.l") ==
          Approx(s * bone(before, "foreArm.l", "hand.l")).epsilon(1e-6));
  }
  CHECK(lengthOf(arm, atFrame(moving, motion, 12)) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  checkGoesWithEnd(moving, motion, "finger1a.l", arm.endNode);
  CHECK(worstMiss(moving, rekeyedOf(moving, trails), 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE(
    "a box that hangs elsewhere goes with the hand within a fifth of the arm, unless it is much larger") {
  const auto goesWithHand = [](double away, double side) { // lengths of the arm
    MovingBiped moving = still(namedBody());
    const Limb& arm = moving.limb("left-arm");
    const Vec3 middle =
        endPosition(arm, bindPoseWorlds(moving.scene)) + Vec3(0.0, away * arm.restLength, 0.0);
    const Vec3 half(0.5 * side * arm.restLength);
    const NodeIndex box = hangBox(moving.scene, moving.node.at("root"), middle - half, middle + half);
    const std::vector<NodeIndex> companions =
        limbTopology(moving.scene, arm, moving.body.limbs, bindPlaces(moving.scene)).companions;
    return std::ranges::find(companions, box) != companions.end();
  };
  CHECK(goesWithHand(0.18, 0.1));
  CHECK_FALSE(goesWithHand(0.22, 0.1));
  CHECK(goesWithHand(0.0, 0.58));
  CHECK_FALSE(goesWithHand(0.0, 0.62));
}

TEST_CASE("a rigid mesh rides on a bone of spine or neck within one and a half of its length, of a limb "
          "within half") {
  const auto rides = [](const std::string& limb, const std::string& from, const std::string& to,
                        double away) {
    MovingBiped moving = still(namedBody());
    const std::vector<Mat4> bind = bindPoseWorlds(moving.scene);
    const Vec3 start = positionOf(bind[at(moving.node.at(from))]);
    const Vec3 bone = positionOf(bind[at(moving.node.at(to))]) - start;
    const Vec3 aside = glm::normalize(glm::cross(bone, Vec3(0.3, 0.2, 1.0)));
    const Vec3 middle = start + 0.5 * bone + away * glm::length(bone) * aside;
    const NodeIndex box =
        hangBox(moving.scene, moving.node.at(from), middle - Vec3(0.01), middle + Vec3(0.01));
    const LimbTopology topology =
        limbTopology(moving.scene, moving.limb(limb), moving.body.limbs, bindPlaces(moving.scene));
    const auto& nodes = topology.bones.front().twistNodes;
    return std::ranges::find(nodes, box) != nodes.end();
  };
  for (const auto& [limb, from, to, most] :
       {std::tuple("neck", "neck0", "head", 1.5), std::tuple("spine", "spine0", "spine1", 1.5),
        std::tuple("left-arm", "upperArm.l", "foreArm.l", 0.5),
        std::tuple("right-leg", "thigh.r", "shin.r", 0.5)}) {
    CAPTURE(limb);
    CHECK(rides(limb, from, to, most - 0.05));
    CHECK_FALSE(rides(limb, from, to, most + 0.05));
  }
}

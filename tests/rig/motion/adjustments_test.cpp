#include "rig/adjust/apply_adjustments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/adjust/solve_adjustments.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/controllers/controller.h"
#include "rig/controllers/finger_joints.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double heightShare = 1e-4;

Vec3 placeOf(const MovingBiped& moving, const FrameState& frame, const std::string& key) {
  return positionOf(frame.worlds[at(moving.node.at(key))]);
}

double turnBetween(const MovingBiped& moving, const FrameState& a, const FrameState& b,
                   const std::string& key) {
  const auto node = at(moving.node.at(key));
  const Quat turn = rotationOf(b.worlds[node]) * glm::inverse(rotationOf(a.worlds[node]));
  return 2.0 * std::atan2(glm::length(Vec3(turn.x, turn.y, turn.z)), std::abs(turn.w)) * 180.0 / pi;
}

std::vector<MovingBiped> differentBipeds() {
  std::vector<MovingBiped> bipeds;
  for (int kind = 0; kind < 4; ++kind) {
    SyntheticBiped body = namedBody();
    body.armatureScale = kind == 1 ? 0.01 : 1.0;
    body.facesBackwards = kind == 2;
    body.posedAtRest = kind == 3;
    bipeds.push_back(still(body));
    addPunch(bipeds.back(), Interpolation::linear);
  }
  return bipeds;
}

// The scene's axes as a joint carries them from the bind pose.
Quat axesOf(const MovingBiped& moving, const FrameState& frame, const std::string& key) {
  const auto node = at(moving.node.at(key));
  return rotationOf(frame.worlds[node]) * glm::inverse(rotationOf(bindPoseWorlds(moving.scene)[node]));
}

} // namespace

TEST_CASE("controls that are not offset leave every node exactly where it was, and make no keys") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Adjustment> none{moved("left-hand", Vec3(0.0)), turned("hips", Vec3(0.0)),
                                     valued("left-arm.stretch", 0.3), valued("left-leg.follow", 0.5)};
  const Rekeyed rekeyed = rekeyedOf(moving, none);
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    CHECK(atFrame(moving, rekeyed.motion, frame).worlds == sourceAtFrame(moving, frame).worlds);
  }
  CHECK(rekeyed.keys.tracks.empty());
  CHECK(rekeyed.keys.stretches.empty());
}

TEST_CASE("a hand is where it was asked to be, at every frame and half frame of the keyed clip") {
  for (const MovingBiped& moving : differentBipeds()) {
    const double height = moving.body.height;
    const Vec3 move = height * Vec3(-0.05, 0.06, 0.04);
    const Rekeyed rekeyed = rekeyedOf(moving, {moved("left-hand", move)});
    for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
      const FrameState source = sourceAtFrame(moving, frame);
      const Vec3 wanted = placeOf(moving, source, "hand.l") + axesOf(moving, source, "spine2") * move;
      CHECK(glm::length(placeOf(moving, atFrame(moving, rekeyed.motion, frame), "hand.l") - wanted) <
            1e-9 * height);
      CHECK(glm::length(placeOf(moving, poseOf(moving, rekeyed.clip, frame), "hand.l") - wanted) <
            heightShare * height);
    }
  }
}

TEST_CASE("a hand and a foot reach their places on limbs whose joints are scaled unevenly") {
  MovingBiped moving = punchingBiped();
  for (const char* key : {"upperArm.l", "thigh.l", "foreArm.l"}) {
    moving.scene.nodes[at(moving.node.at(key))].rest.scale = {1.1, 0.8, 1.0};
  }
  const MotionState motion =
      adjusted(moving, {moved("left-hand", {0.05, 0.1, -0.05}), moved("hips", {0, -0.1, 0})});
  for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
    FrameState state = sourceAtFrame(moving, frame);
    const Vec3 foot = placeOf(moving, state, "foot.l");
    const std::vector<AskedPlace> asked = applyAdjustments(moving.scene, motion.adjustments, state);
    const auto hand = std::find_if(asked.begin(), asked.end(),
                                   [](const AskedPlace& place) { return place.controller == "left-hand"; });
    REQUIRE(hand != asked.end());
    CHECK(glm::length(placeOf(moving, state, "hand.l") - hand->place) < 1e-6);
    CHECK(glm::length(placeOf(moving, state, "foot.l") - foot) < 1e-6);
  }
}

TEST_CASE("feet stay where they are while the hips go down, and keep their orientation") {
  for (const MovingBiped& moving : differentBipeds()) {
    const double height = moving.body.height;
    const Rekeyed rekeyed =
        rekeyedOf(moving, {moved("hips", Vec3(0.02, -0.1, 0.0) * height), turned("spine-top", {20, 0, 0})});
    for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
      const FrameState source = sourceAtFrame(moving, frame);
      const FrameState keyed = poseOf(moving, rekeyed.clip, frame);
      for (const char* foot : {"foot.l", "foot.r"}) {
        CHECK(glm::length(placeOf(moving, keyed, foot) - placeOf(moving, source, foot)) <
              heightShare * height);
        CHECK(turnBetween(moving, source, keyed, foot) < 0.1);
      }
      CHECK(std::abs(placeOf(moving, keyed, "hips").y - placeOf(moving, source, "hips").y + 0.1 * height) <
            heightShare * height);
    }
  }
}

TEST_CASE("a change inside a range leaves the keys outside of it as they are, bit for bit") {
  const MovingBiped dense = [] {
    MovingBiped moving = punchingBiped();
    moving.clip = keyedOnEveryFrame(moving.clip);
    return moving;
  }();
  const Rekeyed rekeyed = rekeyedOf(dense, {within(moved("left-hand", {0.0, 0.2, 0.0}), 8.0, 16.0)});
  const NodeIndex arm = dense.node.at("upperArm.l");
  const Track* const source = sourceTrack(dense.clip, arm, Channel::rotation);
  const Track* const keyed = sourceTrack(rekeyed.clip, arm, Channel::rotation);
  REQUIRE(source != nullptr);
  REQUIRE(keyed != nullptr);
  for (const float time : source->times) {
    const double frame = static_cast<double>(time) * 24.0;
    if (frame < 7.9 || frame > 16.1) {
      CHECK(keyNumbers(*keyed, time) == keyNumbers(*source, time));
    }
  }
  CHECK(worstMiss(dense, rekeyed, 0, 24) < heightShare * dense.body.height);
  CHECK(placeOf(dense, poseOf(dense, rekeyed.clip, 12.0), "hand.l").y >
        placeOf(dense, sourceAtFrame(dense, 12.0), "hand.l").y + 0.15);
}

TEST_CASE("a stepped key jumps from one frame to the next in the keyed clip, too") {
  const MovingBiped moving = punchingBiped();
  Adjustment steps = moved("right-hand", {0.0, 0.1, 0.0}, 0.0);
  steps.keys.push_back(moved("right-hand", {0.0, -0.1, 0.0}, 10.0).keys.front());
  steps.keys.front().interpolation = KeyInterpolation::stepped;
  const Rekeyed rekeyed = rekeyedOf(moving, {steps});
  CHECK(worstMiss(moving, rekeyed, 0, 24) < heightShare * moving.body.height);
  const double before = placeOf(moving, poseOf(moving, rekeyed.clip, 9.99), "hand.r").y;
  const double after = placeOf(moving, poseOf(moving, rekeyed.clip, 10.0), "hand.r").y;
  CHECK(before - after > 0.15);
}

TEST_CASE("a key that stands at the end of its range is held to there and not beyond") {
  const MovingBiped moving = punchingBiped();
  const Rekeyed rekeyed = rekeyedOf(moving, {within(moved("right-hand", {0.0, 0.1, 0.0}, 12.0), 4.0, 12.0)});
  const FrameState source = sourceAtFrame(moving, 12.0);
  CHECK(glm::length(placeOf(moving, poseOf(moving, rekeyed.clip, 12.0), "hand.r") -
                    placeOf(moving, source, "hand.r")) > 0.09);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < heightShare * moving.body.height);
  CHECK(glm::length(placeOf(moving, poseOf(moving, rekeyed.clip, 12.5), "hand.r") -
                    placeOf(moving, sourceAtFrame(moving, 12.5), "hand.r")) < 1e-4);
}

TEST_CASE("a key that stands at the start of its range counts from there and not before") {
  const MovingBiped moving = punchingBiped();
  const Rekeyed rekeyed = rekeyedOf(moving, {within(moved("right-hand", {0.0, 0.1, 0.0}, 6.0), 6.0, 12.0)});
  const auto away = [&](double frame) {
    return glm::length(placeOf(moving, poseOf(moving, rekeyed.clip, frame), "hand.r") -
                       placeOf(moving, sourceAtFrame(moving, frame), "hand.r"));
  };
  CHECK(away(6.0) > 0.09);
  CHECK(away(5.99) < 1e-4);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < heightShare * moving.body.height);
}

TEST_CASE("a trail starts from the adjusted clip") {
  const MovingBiped moving = punchingBiped();
  const Vec3 move(0.0, 0.15, 0.1);
  const Trail trail = connectedTrail("left-arm", 6.0, 12.0, 2.0);
  const MotionState plain = adjusted(moving, {}, {trail});
  const MotionState motion = adjusted(moving, {moved("left-hand", move)}, {trail});
  const FrameState asAdjusted = atFrame(moving, adjusted(moving, {moved("left-hand", move)}), 12.0);
  const LimbSample& tip = motion.trails.front().path.samples.back();
  CHECK(glm::length(tip.end - placeOf(moving, asAdjusted, "hand.l")) < 1e-9);
  CHECK(glm::length(tip.end - plain.trails.front().path.samples.back().end) > 0.1);
  const DrawnTrail drawn = pathsAt(moving.scene, moving.clip, motion, 0, {6.0, 12.0});
  CHECK(glm::length(drawn.original.back() - tip.end) < 1e-9);
  const double before = lengthOf(moving.limb("left-arm"), asAdjusted);
  CHECK(std::abs(lengthOf(moving.limb("left-arm"), atFrame(moving, motion, 12.0)) - 2.0 * before) < 1e-3);
}

TEST_CASE("the body carries everything as one piece, feet included") {
  for (const MovingBiped& moving : differentBipeds()) {
    const Vec3 move(0.3, 0.1, -0.2);
    const MotionState motion = adjusted(moving, {moved("body", move)});
    const FrameState source = sourceAtFrame(moving, 9.0);
    const FrameState frame = atFrame(moving, motion, 9.0);
    for (const char* key : {"hips", "hand.l", "foot.r", "head", "toe.l"}) {
      CHECK(glm::length(placeOf(moving, frame, key) - placeOf(moving, source, key) - move) < 1e-9);
    }
  }
}

TEST_CASE("a pole turns the knee out while hip and foot stay") {
  const MovingBiped moving = punchingBiped();
  const FrameState source = sourceAtFrame(moving, 6.0);
  const FrameState frame = atFrame(moving, adjusted(moving, {moved("left-knee", {0.8, 0.0, 0.0})}), 6.0);
  CHECK(placeOf(moving, frame, "shin.l").x > placeOf(moving, source, "shin.l").x + 0.05);
  for (const char* key : {"thigh.l", "foot.l", "toe.l"}) {
    CHECK(glm::length(placeOf(moving, frame, key) - placeOf(moving, source, key)) < 1e-9);
  }
}

TEST_CASE("the top of the spine takes its place and turn exactly, and the hands go along") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Adjustment> bend{moved("spine-top", {0.0, -0.05, 0.15}), turned("spine-top", {45, 0, 0})};
  const MotionState motion = adjusted(moving, bend);
  const FrameState source = sourceAtFrame(moving, 12.0);
  const FrameState frame = atFrame(moving, motion, 12.0);
  const std::string chest = "spine2";
  const Vec3 wanted =
      placeOf(moving, source, chest) + axesOf(moving, source, "hips") * Vec3(0.0, -0.05, 0.15);
  CHECK(glm::length(placeOf(moving, frame, chest) - wanted) < 1e-9);
  CHECK(std::abs(turnBetween(moving, source, frame, chest) - 45.0) < 1e-6);
  CHECK(std::abs(turnBetween(moving, source, frame, "hand.r") - 45.0) < 1e-6);
  CHECK(std::abs(lengthOf(moving.limb("right-arm"), frame) - lengthOf(moving.limb("right-arm"), source)) <
        1e-9);
}

TEST_CASE("a head turns by what it is told, and a hand that follows nothing stays in the world") {
  const MovingBiped moving = punchingBiped();
  const FrameState source = sourceAtFrame(moving, 12.0);
  const FrameState frame =
      atFrame(moving,
              adjusted(moving, {turned("head", {0, 60, 0}), valued("right-arm.follow", 0.0),
                                moved("hips", {0.0, -0.1, 0.05})}),
              12.0);
  CHECK(std::abs(turnBetween(moving, source, frame, "head") - 60.0) < 1e-6);
  CHECK(glm::length(placeOf(moving, frame, "hand.r") - placeOf(moving, source, "hand.r")) < 1e-9);
  CHECK(glm::length(placeOf(moving, frame, "hand.l") - placeOf(moving, source, "hand.l")) > 0.1);
}

TEST_CASE("a clavicle is turned and the hand stays with the chest") {
  const MovingBiped moving = punchingBiped();
  const std::string clavicle = moving.scene.nodes[at(moving.node.at("clavicle.r"))].name;
  const FrameState source = sourceAtFrame(moving, 12.0);
  const FrameState frame = atFrame(moving, adjusted(moving, {turned(clavicle, {0, 0, 20})}), 12.0);
  CHECK(std::abs(turnBetween(moving, source, frame, "clavicle.r") - 20.0) < 1e-6);
  CHECK(glm::length(placeOf(moving, frame, "hand.r") - placeOf(moving, source, "hand.r")) < 1e-9);
}

TEST_CASE("a rolled foot lifts its heel about the ball, whose toes stay flat") {
  const MovingBiped moving = punchingBiped();
  const FrameState source = sourceAtFrame(moving, 0.0);
  const FrameState frame = atFrame(moving, adjusted(moving, {valued("right-foot.roll", 1.0)}), 0.0);
  CHECK(glm::length(placeOf(moving, frame, "toe.r") - placeOf(moving, source, "toe.r")) < 1e-9);
  CHECK(turnBetween(moving, source, frame, "toe.r") < 1e-6);
  CHECK(placeOf(moving, frame, "foot.r").y > placeOf(moving, source, "foot.r").y + 0.03);
  const FrameState back = atFrame(moving, adjusted(moving, {valued("right-foot.roll", -1.0)}), 0.0);
  CHECK(placeOf(moving, back, "toe.r").y > placeOf(moving, source, "toe.r").y + 0.03);
}

TEST_CASE("a curl of one makes a fist, by the fingers' joints alone") {
  const MovingBiped moving = punchingBiped();
  const FrameState source = sourceAtFrame(moving, 0.0);
  const FrameState frame = atFrame(moving, adjusted(moving, {valued("right-hand.curl", 1.0)}), 0.0);
  const std::vector<NodeIndex> fingers = fingerJoints(moving.scene, moving.limb("right-arm"));
  REQUIRE(!fingers.empty());
  double nearer = 0.0;
  for (const NodeIndex joint : fingers) {
    const auto reach = [&](const FrameState& state) {
      return glm::length(positionOf(state.worlds[at(joint)]) - placeOf(moving, state, "hand.r"));
    };
    nearer = std::max(nearer, reach(source) - reach(frame));
  }
  CHECK(nearer > 0.01);
  CHECK(glm::length(placeOf(moving, frame, "hand.r") - placeOf(moving, source, "hand.r")) <= 0.0);
}

TEST_CASE(
    "fingers that hang on the forearm of an arm without a hand are found, joints that twist it are not") {
  MovingBiped moving = punchingBiped();
  Limb arm = moving.limb("right-arm");
  const NodeIndex hand = arm.endNode;
  arm.joints.push_back(hand);
  arm.endNode = NodeIndex::none;
  const std::array<NodeIndex, 4> joints{
      NodeIndex(moving.scene.nodes.size()), NodeIndex(moving.scene.nodes.size() + 1),
      NodeIndex(moving.scene.nodes.size() + 2), NodeIndex(moving.scene.nodes.size() + 3)};
  moving.scene.nodes.resize(moving.scene.nodes.size() + 4);
  moving.scene.nodes[at(hand)].children = {joints[0], joints[2]};
  for (const std::size_t i : {0U, 1U, 2U, 3U}) {
    moving.scene.skins.front().joints.push_back(joints[i]);
    moving.scene.skins.front().inverseBind.emplace_back(1.0);
    moving.scene.nodes[at(joints[i])].parent = i % 2 == 0 ? hand : joints[i - 1];
  }
  CHECK(fingerJoints(moving.scene, arm).empty());
  moving.scene.nodes[at(joints[0])].children = {joints[1]};
  CHECK(fingerJoints(moving.scene, arm).empty()); // one chain alone twists, too
  moving.scene.nodes[at(joints[2])].children = {joints[3]};
  CHECK(fingerJoints(moving.scene, arm).size() == 4);
}

TEST_CASE("a sword that hangs on a joint of the hand is no finger") {
  MovingBiped moving = punchingBiped();
  const NodeIndex hand = moving.node.at("hand.r");
  const std::vector<NodeIndex> fingers = fingerJoints(moving.scene, moving.limb("right-arm"));
  const NodeIndex slot(moving.scene.nodes.size());
  const NodeIndex sword(moving.scene.nodes.size() + 1);
  moving.scene.nodes.resize(moving.scene.nodes.size() + 2);
  moving.scene.nodes[at(hand)].children.push_back(slot);
  moving.scene.nodes[at(slot)].parent = hand;
  moving.scene.nodes[at(slot)].children = {sword};
  moving.scene.nodes[at(sword)].parent = slot;
  moving.scene.nodes[at(sword)].mesh = 0;
  moving.scene.skins.front().joints.push_back(slot);
  moving.scene.skins.front().inverseBind.emplace_back(1.0);
  CHECK(fingerJoints(moving.scene, moving.limb("right-arm")) == fingers);
  moving.scene.nodes[at(sword)].skin = 0; // part of a glove that the joints bend
  CHECK(fingerJoints(moving.scene, moving.limb("right-arm")).size() == fingers.size() + 1);
}

TEST_CASE("a limb whose stretch is off falls short of what is too far, and points at it") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Adjustment> far{moved("left-hand", {2.0, 0.0, 0.0}), valued("left-arm.stretch", 0.0)};
  const FrameState frame = atFrame(moving, adjusted(moving, far), 12.0);
  const Limb& arm = moving.limb("left-arm");
  CHECK(lengthOf(arm, frame) < 1.0001 * arm.restLength);
  CHECK(lengthOf(arm, frame) > 0.98 * arm.restLength);
  CHECK(lengthOf(arm, atFrame(moving, adjusted(moving, {far.front()}), 12.0)) > 1.5 * arm.restLength);
}

TEST_CASE("a character has the controllers that its limbs allow, and other joints by their names") {
  const MovingBiped moving = punchingBiped();
  const ControllerList list = controllersOf(moving.scene, moving.body.limbs, moving.body.hips);
  for (const char* id :
       {"body", "hips", "spine-low", "spine-mid", "spine-top", "head", "left-hand", "right-hand", "left-foot",
        "right-foot", "left-elbow", "right-elbow", "left-knee", "right-knee"}) {
    CHECK(list.controller(id) != nullptr);
  }
  for (const char* id : {"left-arm.stretch", "spine.volume", "neck.follow", "left-hand.curl",
                         "right-foot.roll", "left-arm.softness", "right-leg.softness"}) {
    CHECK(list.attribute(id) != nullptr);
  }
  CHECK(list.attribute("spine.softness") == nullptr);
  CHECK(list.attribute("spine.follow") == nullptr);
  const auto named = [&](const std::string& id) {
    return controllerNamed(moving.scene, moving.body.limbs, moving.body.hips, list, id);
  };
  CHECK(named("left-hand").ok());
  CHECK(!named("third-hand").ok());
  CHECK(!named(moving.scene.nodes[at(moving.node.at("foreArm.l"))].name).ok());
  std::vector<Limb> noArms = moving.body.limbs;
  std::erase_if(noArms, [](const Limb& limb) { return limb.id == "left-arm"; });
  CHECK(controllersOf(moving.scene, noArms, moving.body.hips).controller("left-hand") == nullptr);
}

TEST_CASE("whatever a key moves is among the nodes that are read and written, any joint of the character's") {
  const MovingBiped moving = punchingBiped();
  const AdjustedBody body = adjustedBody({moving.scene, moving.clip, moving.body.hips, moving.body.limbs});
  REQUIRE(body.jointControllers.size() > 4);
  for (const Controller& joint : body.jointControllers) {
    CAPTURE(joint.id);
    const std::vector<Adjustment> adjustments{turned(joint.id, Vec3(0, 20, 0))};
    const SolvedAdjustments solved = solveAdjustments(
        {{moving.scene, moving.clip, moving.body.hips, moving.body.limbs}, adjustments, nullptr});
    CHECK(std::ranges::find(solved.nodes, joint.node) != solved.nodes.end());
    CHECK(std::ranges::is_sorted(solved.nodes));
    CHECK(std::ranges::find(solved.nodes, NodeIndex::none) == solved.nodes.end());
    REQUIRE(solved.joints.size() == 1);
    CHECK(solved.joints.front().node == joint.node);
  }
}

TEST_CASE("a hand or foot that follows in part goes and turns by that part of what carries it") {
  const MovingBiped moving = punchingBiped();
  const FrameState source = sourceAtFrame(moving, 12.0);
  for (const auto& [attribute, key, carrier] : {std::tuple("right-arm.follow", "hand.r", "spine-top"),
                                                std::tuple("left-leg.follow", "foot.l", "hips")}) {
    const auto at = [&, attribute = attribute, carrier = carrier](double follow) {
      return atFrame(moving, adjusted(moving, {turned(carrier, {0, 40, 0}), valued(attribute, follow)}),
                     12.0);
    };
    for (const double follow : {0.0, 0.25, 0.6, 1.0}) {
      CAPTURE(attribute, follow);
      const Vec3 between = glm::mix(placeOf(moving, at(0.0), key), placeOf(moving, at(1.0), key), follow);
      CHECK(glm::length(placeOf(moving, at(follow), key) - between) < 1e-6);
      CHECK(turnBetween(moving, source, at(follow), key) == Approx(40.0 * follow).margin(1e-4));
    }
  }
}

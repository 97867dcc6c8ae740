#include <algorithm>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/body/evidence/bind_pose.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Turns a joint and all that hangs on it about the joint, as a bind pose that is none of the usual has it.
void pose(SyntheticBiped& body, const std::string& key, const Quat& turn) {
  const Vec3 pivot = jointOf(body, key).position;
  std::vector<std::string> below{key};
  for (std::size_t i = 0; i < below.size(); ++i) {
    for (SyntheticJoint& joint : body.joints) {
      if (joint.parent == below[i]) {
        below.push_back(joint.key);
        joint.position = pivot + turn * (joint.position - pivot);
      }
    }
  }
}

Quat about(const Vec3& axis, double degrees) {
  return axisAngle(glm::normalize(axis), degrees * pi / 180.0);
}

} // namespace

TEST_CASE("well-named limbs are found in any bind pose") {
  const std::string scheme =
      GENERATE(as<std::string>{}, "Mixamo", "Unreal", "3ds Max Biped", "glued lower case");
  const bool clavicles = GENERATE(true, false);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    SyntheticBiped body = makeNamedBody(scheme, {.clavicles = clavicles});
    const bool alike = i % 2 == 0; // both arms and both legs the same
    double drop = 0.0;
    double swing = 0.0;
    double elbow = 0.0;
    for (const std::string side : {".l", ".r"}) {
      const double sign = side == ".l" ? 1.0 : -1.0;
      if (!alike || side == ".l") {
        drop = -30.0 + 120.0 * share(random);
        swing = -30.0 + 120.0 * share(random);
        elbow = 140.0 * share(random);
      }
      pose(body, "foreArm" + side, about({0, -sign, 0}, elbow));
      pose(body, "upperArm" + side, about({0, -sign, 0}, swing) * about({0, 0, -sign}, drop));
      pose(body, "shin" + side, about({1, 0, 0}, 90.0 * share(random)));
      pose(body, "thigh" + side, about({1, 0, 0}, -90.0 * share(random)));
    }
    const BuiltBiped built = build(body);
    CAPTURE(scheme, clavicles, i, drop, swing, elbow);
    checkArmsAndLegs(built, detectBody(built.scene));
  }
}

TEST_CASE("an arm of two joints is found beside one of three") {
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  if (GENERATE(true, false)) {
    body.names.clear();
  }
  std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key == "hand.r"; });
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, biped, biped::rightArm) == "upperArm.r foreArm.r -> estimated");
}

TEST_CASE("the short arms of a tyrannosaur are arms") {
  SyntheticBiped body;
  body.joints = {{"root", "", Vec3(0.0), true, false},   {"hips", "root", Vec3(0, 2.2, 0)},
                 {"spine0", "hips", Vec3(0, 2.3, 0.4)},  {"spine1", "spine0", Vec3(0, 2.4, 0.9)},
                 {"neck0", "spine1", Vec3(0, 2.6, 1.3)}, {"neck1", "neck0", Vec3(0, 3.0, 1.5)},
                 {"head", "neck1", Vec3(0, 3.3, 1.7)},   {"jaw", "head", Vec3(0, 3.2, 1.9)},
                 {"tail0", "hips", Vec3(0, 2.2, -0.5)},  {"tail1", "tail0", Vec3(0, 2.1, -1.3)},
                 {"tail2", "tail1", Vec3(0, 2.0, -2.2)}};
  for (const std::string side : {".l", ".r"}) {
    const double sign = side == ".l" ? 1.0 : -1.0;
    const auto add = [&](const std::string& key, const std::string& parent, const Vec3& place) {
      body.joints.push_back({key + side, parent, Vec3(sign * place.x, place.y, place.z)});
    };
    add("thigh", "hips", {0.35, 2.0, 0.0});
    add("shin", "thigh" + side, {0.4, 1.2, 0.4});
    add("foot", "shin" + side, {0.4, 0.5, -0.2});
    add("toe", "foot" + side, {0.4, 0.1, 0.2});
    add("upperArm", "spine1", {0.3, 2.1, 1.2});
    add("foreArm", "upperArm" + side, {0.33, 1.9, 1.25});
    add("hand", "foreArm" + side, {0.32, 1.8, 1.4});
    add("finger", "hand" + side, {0.32, 1.75, 1.48});
  }
  const NamingScheme scheme{"tyrannosaur",
                            "L",
                            "R",
                            {{"hips", "Hips"},
                             {"spine0", "Spine"},
                             {"spine1", "Spine1"},
                             {"neck0", "Neck"},
                             {"neck1", "Neck1"},
                             {"head", "Head"},
                             {"jaw", "Jaw"},
                             {"tail0", "Tail"},
                             {"tail1", "Tail1"},
                             {"tail2", "Tail2"},
                             {"thigh", "Thigh_%"},
                             {"shin", "Calf_%"},
                             {"foot", "Foot_%"},
                             {"toe", "Toe_%"},
                             {"upperArm", "UpperArm_%"},
                             {"foreArm", "Forearm_%"},
                             {"hand", "Hand_%"},
                             {"finger", "Finger_%"}}};
  SECTION("by their names") {
    applyNames(body, scheme);
  }
  SECTION("without names") {}
  const BuiltBiped built = build(body);
  const Body dinosaur = detectBody(built.scene);
  CHECK(dinosaur.plan == "bird");
  CHECK(describe(built, dinosaur, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, dinosaur, biped::rightLeg) == "thigh.r shin.r foot.r -> toe.r");
  CHECK(describe(built, dinosaur, biped::neck) == "neck0 neck1 -> head");
  CHECK(describe(built, dinosaur, {LimbKind::tail}) == "tail0 tail1 -> tail2");
}

TEST_CASE("joints above the hips that stand on the ground are no spine") {
  SyntheticBiped body = makeBody({.spineJoints = GENERATE(0, 1, 2)});
  const bool hasNames = GENERATE(true, false);
  if (hasNames) {
    applyNames(body, namingScheme("Mixamo"));
  }
  std::string above;
  for (const std::string key : {"RootNode", "Armature", "Root"}) {
    body.joints.push_back({key, above, Vec3(0.0), true, false});
    body.names[key] = key;
    above = key;
  }
  jointOf(body, "root").parent = above;
  // The legs hang from the root, the trunk begins beside them.
  if (GENERATE(true, false)) {
    jointOf(body, "thigh.l").parent = "Root";
    jointOf(body, "thigh.r").parent = "Root";
  }
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  const Limb* spine = findLimb(biped, biped::spine);
  REQUIRE(spine != nullptr);
  for (const NodeIndex joint : spine->joints) {
    CHECK(positionOf(bindPoseWorlds(built.scene)[at(joint)]).y > 0.5);
  }
}

TEST_CASE("a neck ends at the head, not at the cap on it") {
  SyntheticBiped body = makeBody({.neckJoints = 1});
  const bool hasNames = GENERATE(true, false);
  if (hasNames) {
    applyNames(body, namingScheme("Mixamo"));
  }
  const std::string name = GENERATE(as<std::string>{}, "", "Cap", "Hat_01");
  body.joints.push_back({"cap", "head", Vec3(0, 1.74, 0.02)});
  body.joints.push_back({"capTop", "cap", Vec3(0, 1.95, 0.02)});
  body.names["cap"] = name;
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CAPTURE(hasNames, name);
  CHECK(describe(built, biped, biped::neck) == "neck0 -> head");
  CHECK(biped.head == built.node.at("head"));
}

TEST_CASE("the spine is read from the joints that deform, not from weightless ones beside them") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  const bool clearNames = GENERATE(true, false);
  // Controls in the skin: the chain that carries arms and head, each with its deforming joint beside it.
  for (int i = 0; i < 3; ++i) {
    const std::string spine = "spine" + std::to_string(i);
    const std::string master = "master" + std::to_string(i);
    const std::string above = i == 0 ? "hips" : "master" + std::to_string(i - 1);
    body.joints.push_back({master, above, jointOf(body, spine).position, true, false});
    body.names[master] = clearNames ? "ctrl_spine_" + std::to_string(i) : "Spine_" + std::to_string(i) + "_M";
    jointOf(body, spine).parent = i == 0 ? "hips" : "spine" + std::to_string(i - 1);
  }
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(describe(built, biped, biped::spine) == "spine0 spine1 -> spine2");
}

TEST_CASE("rigid arms on a skinned body are found, whether the skin lists their joints or not") {
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  const bool listed = GENERATE(true, false);
  for (SyntheticJoint& joint : body.joints) {
    const std::string stem = joint.key.substr(0, joint.key.find('.'));
    if (stem == "upperArm" || stem == "foreArm" || stem == "hand") {
      joint.isJoint = listed;
      joint.movesMesh = false;
    }
  }
  BuiltBiped built = build(body);
  for (const auto& [key, node] : std::map<std::string, NodeIndex>(built.node)) {
    const std::string stem = key.substr(0, key.find('.'));
    if (stem == "upperArm" || stem == "foreArm" || stem == "hand") {
      const double reach = (key.ends_with(".l") ? 1.0 : -1.0) * (stem == "hand" ? 0.15 : 0.25);
      Primitive box;
      box.positions = {{0, -0.05F, 0}, {reach, 0.05F, 0.05F}, {reach, -0.05F, -0.05F}};
      const NodeIndex part = addNode(built.scene, "part", node, Vec3(0.0));
      built.scene.nodes[at(part)].mesh = static_cast<int>(built.scene.meshes.size());
      built.scene.meshes.push_back({"part", {box}, {}});
    }
  }
  checkArmsAndLegs(built, detectBody(built.scene));
}

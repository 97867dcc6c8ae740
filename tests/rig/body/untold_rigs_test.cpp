#include <algorithm>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/body/reading/detection.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

void add(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  body.joints.push_back({key, parent, place});
}

// A row of joints on either side, each `step` from the one before.
void addRows(SyntheticBiped& body, const std::string& stem, const std::string& parent, const Vec3& place,
             const Vec3& step, int count) {
  for (const auto& [side, sign] : sides) {
    std::string above = parent;
    for (int i = 0; i < count; ++i) {
      const Vec3 here = place + static_cast<double>(i) * step;
      const std::string key = stem + std::to_string(i) + side;
      add(body, key, above, {sign * here.x, here.y, here.z});
      above = key;
    }
  }
}

double confidenceOf(const Body& body, const LimbPlace& place) {
  const Limb* const limb = findLimb(body, place);
  REQUIRE(limb != nullptr);
  return limb->confidence;
}

} // namespace

TEST_CASE("A root in the middle of a serpent or below it is no part of its row") {
  SyntheticBiped body = makeSnake();
  const Vec3 root = GENERATE(Vec3(0.0, 0.06, 0.2), Vec3(0.0, -0.5, 0.2));
  body.joints.insert(body.joints.begin(), {"root", "", root, true, false});
  jointOf(body, "segment0").parent = "root";
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "serpent");
  CHECK(describe(built, read, biped::spine).starts_with("segment0 segment1 "));
}

TEST_CASE("A body whose joints are called thighs or upper arms is no serpent, whatever it has lost") {
  SyntheticBiped body = makeSnake();
  for (const auto& [side, sign] : sides) {
    add(body, "thigh" + side, "segment8", {sign * 0.1, 0.0, 0.12});
    add(body, "shin" + side, "thigh" + side, {sign * 0.12, 0.02, 0.12});
  }
  const bool isNamed = GENERATE(false, true);
  if (isNamed) {
    applyNames(body, namingScheme("Unreal"));
  }
  CHECK((detectBody(build(body).scene).plan == "serpent") == !isNamed);
}

TEST_CASE("Where one foot under the root is near its leg, the other one that is farther is a foot as well") {
  SyntheticBiped body = makeBody({.toes = false, .fingers = false});
  body.tubes = true;
  for (const auto& [side, share] : {std::pair(std::string(".l"), 0.9), std::pair(std::string(".r"), 0.55)}) {
    SyntheticJoint& foot = jointOf(body, "foot" + side);
    SyntheticJoint& shin = jointOf(body, "shin" + side);
    foot.parent = "root";
    foot.flesh = {0.0, -0.05, 0.15};
    shin.flesh = share * (foot.position - shin.position);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, read, biped::rightLeg) == "thigh.r shin.r -> foot.r");
}

TEST_CASE("A foot under the root belongs to its leg although a kneepad hangs at the knee, and to no tail") {
  SyntheticBiped body = makeNamedBody("Unreal", {.toes = false});
  body.tubes = true;
  for (const auto& [side, sign] : sides) {
    SyntheticJoint& foot = jointOf(body, "foot" + side);
    SyntheticJoint& shin = jointOf(body, "shin" + side);
    foot.parent = "root";
    foot.flesh = {0.0, -0.05, 0.15};
    shin.flesh = 0.9 * (foot.position - shin.position);
    add(body, "patella" + side, "shin" + side, {sign * 0.1, 0.5, 0.06});
  }
  std::string above = "hips";
  for (int i = 0; i < 5; ++i) {
    const std::string key = "tail" + std::to_string(i);
    add(body, key, above, {-0.02 * i, 0.9 - 0.19 * i, -0.1});
    body.names[key] = key;
    above = key;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, read, biped::rightLeg) == "thigh.r shin.r -> foot.r");
  CHECK(describe(built, read, {LimbKind::tail}) == "tail0 tail1 tail2 tail3 -> tail4");
}

TEST_CASE("An insect whose front and hind legs are alike has three pairs, and its middle legs are no tail") {
  SyntheticBiped body;
  add(body, "thorax", "", {0.0, 0.4, 0.0});
  add(body, "head", "thorax", {0.0, 0.4, 0.3});
  add(body, "abdomen", "thorax", {0.0, 0.42, -0.4});
  for (int row = 0; row < 3; ++row) {
    const double z = 0.25 * (1 - row);
    const std::string stem = "leg" + std::to_string(row) + "_";
    addRows(body, stem, "thorax", {0.1, 0.4, z}, {0.3, 0.0, 0.5 * z}, 3);
    for (const auto& [side, sign] : sides) {
      jointOf(body, stem + "1" + side).position.y = 0.6;
      jointOf(body, stem + "2" + side).position.y = 0.02;
    }
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "insect");
  CHECK(warnsOf(read, "nothing tells which end of the body is the head"));
  nameByKeys(body);
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "nothing tells"));
}

TEST_CASE("Wings beside arms that no name tells apart are doubted in words, named ones are not") {
  SyntheticBiped body = makeBody({.fingers = false});
  addRows(body, "wing", "spine2", {0.06, 1.43, -0.12}, {0.22, 0.03, -0.02}, 4);
  const Body read = detectBody(build(body).scene);
  CHECK(warnsOf(read, "other rows of joints may as well be the arms"));
  CHECK(confidenceOf(read, biped::leftArm) < 0.5);
  applyNames(body, namingScheme("Unreal"));
  const Body named = detectBody(build(body).scene);
  CHECK(named.warnings.empty());
  CHECK(confidenceOf(named, biped::leftArm) > 0.8);
}

TEST_CASE("Of two characters in one file the limbs are of one, and that is told") {
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  addOther(body, makeNamedBody("Unreal", {.fingers = false}), {1.6, 0.0, 0.0});
  body.tubes = true;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.isBiped);
  CHECK(warnsOf(read, "2 characters in the file"));
  const std::string leg = describe(built, read, biped::leftLeg);
  CHECK((leg == "thigh.l shin.l -> foot.l" || leg == "other thigh.l other shin.l -> other foot.l"));
  const std::string of = leg.starts_with("other") ? "other " : "";
  CHECK(describe(built, read, biped::rightArm) == of + "upperArm.r " + of + "foreArm.r -> " + of + "hand.r");
  CHECK(read.hips == built.node.at(of + "hips"));
}

TEST_CASE("An arm that ends at a weapon, as no hand is there, is doubted") {
  SyntheticBiped body = makeNamedBody("Unreal", {.hands = false});
  body.withMesh = false;
  for (const auto& [side, sign] : sides) {
    add(body, "weapon" + side, "foreArm" + side, {sign * 0.75, 1.43, 0.05});
    body.names["weapon" + side] = side == ".l" ? "shield" : "sword";
  }
  const Body read = detectBody(build(body).scene);
  CHECK(confidenceOf(read, biped::leftArm) < 0.5);
  CHECK(confidenceOf(read, biped::rightArm) < 0.5);
}

TEST_CASE("A lizard stands on four legs although its tail hangs through the ground") {
  SyntheticBiped body;
  body.tubes = true;
  add(body, "hips", "", {0.0, 0.18, -0.33});
  add(body, "spine0", "hips", {0.0, 0.18, -0.1});
  add(body, "spine1", "spine0", {0.0, 0.18, 0.25});
  add(body, "neck", "spine1", {0.0, 0.18, 0.3});
  add(body, "head", "neck", {0.0, 0.18, 0.36});
  for (const auto& [side, sign] : sides) {
    for (const auto& [stem, parent, z] :
         {std::tuple("Scapula", "spine1", 0.25), std::tuple("leg", "hips", -0.33)}) {
      add(body, stem + std::string("1") + side, parent, {sign * 0.06, 0.16, z});
      add(body, stem + std::string("2") + side, stem + std::string("1") + side, {sign * 0.18, 0.16, z});
      add(body, stem + std::string("3") + side, stem + std::string("2") + side, {sign * 0.18, 0.01, z});
    }
  }
  const double drop = GENERATE(0.0, 0.1);
  std::string above = "hips";
  for (int i = 0; i < 4; ++i) {
    const std::string key = "tail" + std::to_string(i);
    add(body, key, above, {0.0, 0.16 - drop * i, -0.4 - 0.2 * i});
    above = key;
  }
  nameByKeys(body);
  CHECK(detectBody(build(body).scene).plan == "quadruped");
}

TEST_CASE("A small body far from a root at the origin is read as one that stands at it") {
  SyntheticBiped body = makeBody({.fingers = false});
  body.tubes = true;
  for (SyntheticJoint& joint : body.joints) {
    joint.position = joint.key == "root" ? Vec3(0.0) : 0.01 * joint.position + Vec3(2.0, 0.1, 2.0);
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE(
    "A body without names whose trunk stands across its legs is not taken for a biped without a doubt") {
  SyntheticBiped body = makeBird();
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key.starts_with("tail") || joint.key.starts_with("claw") || joint.key.starts_with("wing3");
  });
  for (const auto& [side, sign] : sides) { // wings that are folded
    jointOf(body, "wing1" + side).position = {sign * 0.2, 0.75, 0.3};
    jointOf(body, "wing2" + side).position = {sign * 0.22, 0.6, 0.1};
  }
  jointOf(body, "neck0").position = {0.0, 1.2, 0.55};
  jointOf(body, "neck1").position = {0.0, 1.5, 0.55};
  jointOf(body, "head").position = {0.0, 1.8, 0.6};
  const Body read = detectBody(build(body).scene);
  CHECK((read.plan == "bird" || (read.planConfidence < 0.5 && warnsOf(read, "bird"))));
}

TEST_CASE("Where nothing tells which way a body faces, its sides are asked for") {
  SyntheticBiped body = makeBody({.toes = false, .fingers = false});
  body.withMesh = false;
  for (SyntheticJoint& joint : body.joints) {
    joint.position.z = 0.0;
  }
  CHECK(warnsOf(detectBody(build(body).scene), "nothing tells which way the character faces"));
  applyNames(body, namingScheme("Mixamo"));
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "nothing tells"));
}

TEST_CASE("A joint on the upper arm that is called biceps continues it, and no arm begins there") {
  SyntheticBiped body = makeNamedBody("3ds Max Biped", {.fingers = false});
  body.withMesh = false;
  for (const auto& [side, sign] : sides) {
    addTwist(body, "biceps" + side, "upperArm" + side, "foreArm" + side, 0.33, true);
    body.names["biceps" + side] = side == ".l" ? "Bip01 L Bicep" : "Bip01 R Bicep";
    const Vec3 shoulder = jointOf(body, "upperArm" + side).position;
    jointOf(body, "clavicle" + side).position = shoulder - Vec3(sign * 0.14, 0.0, 0.0);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm).starts_with("upperArm.l "));
  CHECK(describe(built, read, biped::rightArm).starts_with("upperArm.r "));
}

TEST_CASE("Where no name tells whether a bird's front limbs are arms or wings, that is asked") {
  SyntheticBiped body = makeBird();
  CHECK(warnsOf(detectBody(build(body).scene), "arms or wings"));
  nameByKeys(body);
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "arms or wings"));
}

TEST_CASE("Where names put both legs of a pair on one side, that is asked") {
  SyntheticBiped body = makeManyLegged(4);
  nameByKeys(body);
  REQUIRE(detectBody(build(body).scene).warnings.empty());
  for (int row = 0; row < 4; ++row) { // the fore half of the body is called left
    for (const auto& [side, sign] : sides) {
      for (const char* const bone : {"coxa", "femur", "tibia", "tarsus"}) {
        const std::string key = bone + std::to_string(row) + side;
        body.names[key] = bone + std::to_string(row) + (sign > 0.0 ? "a" : "b") + (row < 2 ? "_L" : "_R");
      }
    }
  }
  CHECK(warnsOf(detectBody(build(body).scene), "both limbs of a pair on one side"));
}

TEST_CASE("Limbs that names call legs are no arms without a doubt, however the beast stands") {
  SyntheticBiped body = makeBody({.toes = false, .fingers = false});
  applyNames(body, {"a bear on its hind legs",
                    "L",
                    "R",
                    {{"hips", "Hips"},
                     {"spine0", "Spine0"},
                     {"spine1", "Spine1"},
                     {"spine2", "Spine2"},
                     {"neck0", "Neck"},
                     {"head", "Head"},
                     {"clavicle", "Shoulder.%"},
                     {"upperArm", "front_thigh.%"},
                     {"foreArm", "front_shin.%"},
                     {"hand", "front_foot.%"},
                     {"thigh", "thigh.%"},
                     {"shin", "shin.%"},
                     {"foot", "foot.%"}}});
  for (const auto& [side, sign] : sides) {
    jointOf(body, "hand" + side).position.x = sign * 0.85;
  }
  CHECK(warnsOf(detectBody(build(body).scene), "its arms are called legs"));
}

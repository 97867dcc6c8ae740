#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Beasts as exporters leave them: in pieces, with joints in the middle, with soft parts and faces.

const LimbPlace frontLeft{LimbKind::leg, LimbSide::left, 1};
const LimbPlace frontRight{LimbKind::leg, LimbSide::right, 1};
const LimbPlace hindLeft{LimbKind::leg, LimbSide::left, 2};
const LimbPlace hindRight{LimbKind::leg, LimbSide::right, 2};

void addBoth(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    body.joints.push_back({key + side, parent, {sign * place.x, place.y, place.z}});
  }
}

void cutLoose(SyntheticBiped& body, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    jointOf(body, key).parent = "";
  }
}

void checkHorse(const SyntheticBiped& body) {
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "quadruped");
  CHECK(describe(built, read, frontLeft) ==
        "scapula.l forearmLeg.l frontKnee.l frontPastern.l -> frontHoof.l");
  CHECK(describe(built, read, frontRight) ==
        "scapula.r forearmLeg.r frontKnee.r frontPastern.r -> frontHoof.r");
  CHECK(describe(built, read, hindLeft) == "thigh.l calf.l hock.l pastern.l -> hoof.l");
  CHECK(describe(built, read, hindRight) == "thigh.r calf.r hock.r pastern.r -> hoof.r");
}

} // namespace

TEST_CASE("Legs that hang from nothing mirror those across the body, not those behind them") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  cutLoose(body, {"scapula.l", "scapula.r", "thigh.l", "thigh.r"});
  checkHorse(body);
}

TEST_CASE("Forequarters and hindquarters on two joints of one place are no images of each other") {
  SyntheticBiped body = makeHorse();
  body.joints.push_back({"middle", "", {0.0, 1.35, -0.2}});
  body.joints.push_back({"fore", "middle", {0.0, 1.35, -0.2}});
  body.joints.push_back({"hind", "middle", {0.0, 1.35, -0.2}});
  jointOf(body, "hips").parent = "hind";
  jointOf(body, "spine0").parent = "fore";
  checkHorse(body);
}

TEST_CASE("Toes that hang from a handle in the foot's place are none of the leg's joints") {
  SyntheticBiped body = makeHorse();
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    body.joints.push_back({"handle" + side, "hips", jointOf(body, "hoof" + side).position, true, false});
    body.joints.push_back({"claw0" + side, "handle" + side, {sign * 0.2, 0.04, -0.66}});
    body.joints.push_back({"claw1" + side, "claw0" + side, {sign * 0.2, 0.03, -0.6}});
  }
  nameByKeys(body);
  body.names["handle.l"] = "foot_ik.l";
  body.names["handle.r"] = "foot_ik.r";
  checkHorse(body);
}

TEST_CASE("A leg starts at the thigh, in the middle of the body and in two halves as well") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  SECTION("in the middle") {
    for (const std::string side : {".l", ".r"}) {
      jointOf(body, "thigh" + side).position.x = 0.0;
    }
  }
  SECTION("in halves, each a short bone") {
    for (const std::string side : {".l", ".r"}) {
      jointOf(body, "calf" + side).position = {side == ".l" ? 0.2 : -0.2, 0.85, -0.7};
      addTwist(body, "half" + side, "thigh" + side, "calf" + side, 0.45, true);
    }
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, hindLeft).starts_with("thigh.l "));
  CHECK(describe(built, read, hindRight).starts_with("thigh.r "));
}

TEST_CASE("Joints that move the flanks of a beast are no limbs") {
  SyntheticBiped body = makeHorse();
  addBoth(body, "flank0", "spine0", {0.3, 1.2, -0.45});
  addBoth(body, "flank1", "flank0", {0.3, 1.2, 0.25});
  for (const std::string side : {".l", ".r"}) {
    jointOf(body, "flank1" + side).parent += side;
  }
  checkHorse(body);
}

TEST_CASE("Pincers that are called arms leave a spider what it is") {
  SyntheticBiped body = makeManyLegged(4);
  addBoth(body, "arm0", "thorax", {0.1, 0.4, 0.5});
  addBoth(body, "arm1", "arm0", {0.35, 0.5, 0.8});
  addBoth(body, "arm2", "arm1", {0.2, 0.4, 1.1});
  for (const std::string side : {".l", ".r"}) {
    jointOf(body, "arm1" + side).parent += side;
    jointOf(body, "arm2" + side).parent += side;
  }
  nameByKeys(body);
  const Body read = detectBody(build(body).scene);
  CHECK(read.plan == "spider");
  CHECK(findLimb(read, {LimbKind::leg, LimbSide::right, 4}) != nullptr);
}

TEST_CASE("A leg ends at the foot where toes go on along the ground, however thick the sole is") {
  SyntheticBiped body = makeHorse();
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    jointOf(body, "hoof" + side).position = {sign * 0.2, 0.13, -0.7};
    body.joints.push_back({"toe" + side, "hoof" + side, {sign * 0.2, 0.05, -0.5}});
  }
  checkHorse(body);
}

TEST_CASE("A face of hundreds of joints hides no legs") {
  SyntheticBiped body = makeHorse();
  for (int i = 0; i < 80; ++i) {
    addBoth(body, "lip" + std::to_string(i), "head", {0.03 + 0.001 * i, 1.9, 1.0 + 0.001 * i});
  }
  nameByKeys(body);
  checkHorse(body);
}

TEST_CASE("The front of a beast whose joints start at its chest is where its sides, feet and head say") {
  SyntheticBiped body = makeHorse();
  jointOf(body, "spine1").parent = "";
  jointOf(body, "spine0").parent = "spine1";
  jointOf(body, "hips").parent = "spine0";
  SECTION("names tell left and right only") {
    int number = 0;
    for (const SyntheticJoint& joint : body.joints) {
      const std::string side = joint.key.substr(joint.key.size() - 2);
      body.names[joint.key] = "Bone" + std::to_string(++number) + (side == ".l" || side == ".r" ? side : "");
    }
  }
  SECTION("nothing is named") {}
  checkHorse(body);
}

TEST_CASE(
    "Legs of one pair alone that are called front or hind ones do not turn a beast, wherever it stands") {
  const bool isHind = GENERATE(true, false);
  const double away = GENERATE(-10.0, 0.0, 10.0);
  CAPTURE(isHind, away);
  const std::vector<std::string> hind{"thigh", "calf", "hock", "pastern", "hoof"};
  SyntheticBiped body = makeHorse();
  int number = 0;
  for (SyntheticJoint& joint : body.joints) {
    const std::string part = joint.key.substr(0, joint.key.find('.'));
    const bool isOfHind = std::ranges::find(hind, part) != hind.end();
    const bool isOfFront = part == "scapula" || part == "forearmLeg" || part.starts_with("front");
    const std::string word = isOfHind && isHind ? "hindLeg" : isOfFront && !isHind ? "frontLeg" : "Bone";
    body.names[joint.key] = word + std::to_string(++number);
    joint.position.z += away;
  }
  checkHorse(body);
}

TEST_CASE("A snake that lies along X is read as one that lies along Z") {
  SyntheticBiped body;
  body.joints = {{"root", "", {0.0, 0.0, 0.0}},
                 {"head", "root", {0.1, 0.13, 0.0}},
                 {"jaw", "head", {0.1, 0.03, 0.0}},
                 {"neck", "root", {0.08, 0.13, 0.0}}};
  std::string above = "neck";
  for (int i = 1; i < 20; ++i) {
    const std::string key = "tail" + std::to_string(i);
    body.joints.push_back({key, above, {0.1 - 0.18 * i, 0.07, 0.0}});
    above = key;
  }
  nameByKeys(body);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "serpent");
  CHECK(describe(built, read, biped::spine).ends_with("tail18 -> tail19"));
}

TEST_CASE("An arm from which feathers hang is a wing, however upright its bird stands") {
  SyntheticBiped body;
  body.joints = {{"hips", "", {0.0, 0.35, 0.0}},          {"spine0", "hips", {0.0, 0.38, 0.06}},
                 {"spine1", "spine0", {0.0, 0.41, 0.12}}, {"neck0", "spine1", {0.0, 0.46, 0.17}},
                 {"neck1", "neck0", {0.0, 0.52, 0.19}},   {"head", "neck1", {0.0, 0.56, 0.2}},
                 {"beak", "head", {0.0, 0.56, 0.28}}};
  const auto add = [&](const std::string& key, const std::string& parent, const Vec3& place) {
    addBoth(body, key, parent, place);
    if (parent.find("spine") == std::string::npos && parent != "hips") {
      jointOf(body, key + ".l").parent += ".l";
      jointOf(body, key + ".r").parent += ".r";
    }
  };
  add("thigh", "hips", {0.05, 0.32, 0.0});
  add("calf", "thigh", {0.05, 0.22, 0.06});
  add("hock", "calf", {0.05, 0.12, -0.03});
  add("foot", "hock", {0.05, 0.02, 0.0});
  add("toe", "foot", {0.05, 0.01, 0.05});
  add("clavicle", "spine1", {0.04, 0.42, 0.13});
  add("upperArm", "clavicle", {0.08, 0.43, 0.12});
  add("foreArm", "upperArm", {0.25, 0.44, 0.05});
  add("hand", "foreArm", {0.42, 0.44, 0.08});
  add("featherUpper", "upperArm", {0.25, 0.43, -0.15});
  add("featherLower", "foreArm", {0.42, 0.43, -0.15});
  nameByKeys(body);
  CHECK(detectBody(build(body).scene).plan == "bird");
}

TEST_CASE("The claws of a crab are feelers, not wings") {
  SyntheticBiped crab = makeManyLegged(4);
  std::erase_if(crab.joints, [](const SyntheticJoint& joint) { return joint.key.starts_with("antenna"); });
  const std::string stem = GENERATE("claw", "pincer", "chela", "pedipalp", "limb");
  addBoth(crab, stem + "0", "thorax", {0.2, 0.4, 0.35});
  for (int i = 1; i < 3; ++i) {
    for (const std::string side : {".l", ".r"}) {
      const double sign = side == ".l" ? 1.0 : -1.0;
      crab.joints.push_back({stem + std::to_string(i) + side,
                             stem + std::to_string(i - 1) + side,
                             {sign * (0.2 + 0.35 * i), 0.4, 0.35 + 0.25 * i}});
    }
  }
  nameByKeys(crab);
  const Body read = detectBody(build(crab).scene);
  REQUIRE(read.plan == "spider");
  const bool hasFeelers = findLimb(read, {LimbKind::feeler, LimbSide::left}) != nullptr;
  const bool asks = std::ranges::any_of(read.warnings, [](const std::string& warning) {
    return warning.find("wings or feelers") != std::string::npos;
  });
  CHECK(hasFeelers == (stem != "limb"));
  CHECK(asks == (stem == "limb")); // No word tells: taken for wings, and asked.
}

TEST_CASE("The tail of a beast that is rooted before its hips begins behind them") {
  SyntheticBiped horse = makeHorse();
  const bool isAtChest = GENERATE(true, false);
  jointOf(horse, "spine0").parent = isAtChest ? "spine1" : "";
  jointOf(horse, "spine1").parent = isAtChest ? "" : "spine0";
  jointOf(horse, "hips").parent = "spine0";
  nameByKeys(horse);
  const BuiltBiped built = build(horse);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(describe(built, read, {LimbKind::tail}).starts_with("tail0 "));
  if (isAtChest) {
    CHECK(describe(built, read, biped::spine) == "spine1 spine0 -> hips");
  }
}

TEST_CASE("A neck goes on to the head beside which a jaw hangs, whatever branches off before it") {
  SyntheticBiped body = makeHorse();
  body.joints.push_back({"breast", "spine1", {0.0, 1.1, 0.3}});
  body.joints.push_back({"chin", "jaw", {0.0, 1.6, 1.3}});
  for (const std::string key : {"scapula.l", "scapula.r"}) {
    jointOf(body, key).parent = "spine0";
  }
  for (const std::string key : {"jaw", "ear.l", "ear.r"}) {
    jointOf(body, key).parent = "neck1";
  }
  std::string wanted = "neck0 neck1 -> head";
  SECTION("a joint is called head") {}
  SECTION("none is") {
    std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key == "head"; });
    wanted = "neck0 -> neck1";
  }
  nameByKeys(body);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "quadruped");
  CHECK(describe(built, read, biped::neck) == "spine1 " + wanted);
  CHECK(describe(built, read, biped::spine) == "spine0 -> spine1");
}

TEST_CASE("A neck that hangs from nothing is no spine, and the trunk is what leads to the hind legs") {
  SyntheticBiped body = makeHorse();
  body.joints.push_back({"trunk", "", {0.0, 1.35, 0.4}});
  std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key.starts_with("spine"); });
  cutLoose(body, {"neck0", "scapula.l", "scapula.r"});
  jointOf(body, "hips").parent = "trunk";
  nameByKeys(body);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::neck) == "neck0 neck1 -> head");
  CHECK(describe(built, read, biped::spine) == "trunk -> hips");
  CHECK(keyOf(built, read.hips) == "hips");
  checkHorse(body);
}

namespace {

/// A horse as rigs of Blender have it: what moves the mesh is called DEF- and hangs side by side, a tongue
/// and a jaw among it, and handles without a mesh hang from a root of their own.
SyntheticBiped horseOfBlender(bool hasHandles, bool isTrunkApart = false) {
  SyntheticBiped body = makeHorse();
  body.joints.push_back({"tongue", "", {0.0, 1.9, 1.15}});
  for (SyntheticJoint& joint : body.joints) {
    const bool isSided = joint.key.ends_with(".l") || joint.key.ends_with(".r");
    const bool isUnderMiddle = !joint.parent.ends_with(".l") && !joint.parent.ends_with(".r");
    joint.parent =
        (isSided && isUnderMiddle) || joint.key == "jaw" || joint.key == "tail0" ? "" : joint.parent;
  }
  for (const SyntheticJoint& joint : body.joints) {
    body.names[joint.key] = "DEF-" + joint.key;
  }
  for (const auto& [key, called] :
       {std::pair("neck0", "DEF-spine2"), {"neck1", "DEF-spine3"}, {"head", "DEF-spine4"}}) {
    body.names[key] = called;
  }
  if (hasHandles) {
    std::string above;
    for (const auto& [key, place] : {std::pair("root", Vec3(0.0)),
                                     {"torso", Vec3(0.0, 1.35, -0.6)},
                                     {"chest", Vec3(0.0, 1.4, 0.1)},
                                     {"jaw_master", Vec3(0.0, 1.9, 1.0)}}) {
      body.joints.push_back({key, above, place, true, false});
      body.names[key] = key;
      above = key;
    }
    for (SyntheticJoint& joint : body.joints) {
      const bool isTop = joint.key == "root" || (isTrunkApart && joint.key == "hips");
      if (joint.parent.empty() && !isTop) {
        joint.parent = joint.key == "jaw" ? "jaw_master" : "torso";
      }
    }
  }
  return body;
}

} // namespace

TEST_CASE("A beast's trunk is what moves its mesh: no tongue by itself, and no handle") {
  const bool hasHandles = GENERATE(false, true);
  const BuiltBiped built = build(horseOfBlender(hasHandles, GENERATE(false, true)));
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(describe(built, read, biped::spine) == "spine0 -> spine1");
  CHECK(describe(built, read, biped::neck) == "neck0 neck1 -> head");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 2}).starts_with("thigh.l "));
}

TEST_CASE("A tail whose joints hang from its tip is doubted") {
  const bool fromTip = GENERATE(true, false);
  SyntheticBiped body = horseOfBlender(false);
  std::vector<std::string> tail;
  for (int i = 0; body.names.contains("tail" + std::to_string(i)); ++i) {
    tail.push_back("tail" + std::to_string(i));
  }
  REQUIRE(tail.size() > 1);
  for (std::size_t i = 0; fromTip && i < tail.size(); ++i) {
    jointOf(body, tail[i]).parent = i + 1 < tail.size() ? tail[i + 1] : "";
  }
  const Body read = detectBody(build(body).scene);
  const Limb* const found = limbAt(read.limbs, {LimbKind::tail});
  REQUIRE(found != nullptr);
  CHECK((found->confidence < 0.5) == fromTip);
}

TEST_CASE("A tail that comes to the hips from its tip is found by its place where no name calls it one") {
  SyntheticBiped body = horseOfBlender(false);
  std::vector<std::string> tail;
  for (int i = 0; body.names.contains("tail" + std::to_string(i)); ++i) {
    tail.push_back("tail" + std::to_string(i));
  }
  for (std::size_t i = 0; i < tail.size(); ++i) {
    jointOf(body, tail[i]).parent = i + 1 < tail.size() ? tail[i + 1] : "";
    body.names[tail[i]] = "DEF-spine.00" + std::to_string(i);
  }
  const bool isApart = GENERATE(false, true); // What ends far from the hips is none.
  for (const std::string& joint : tail) {
    jointOf(body, joint).position.z -= isApart ? 1.0 : 0.0;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  const Limb* const found = limbAt(read.limbs, {LimbKind::tail});
  REQUIRE((found != nullptr) != isApart);
  CHECK((isApart || describe(built, read, {LimbKind::tail}).starts_with(tail.back() + " ")));
  CHECK(warnsOf(read, "guessed, and not sure: tail") != isApart);
}

TEST_CASE("Names of left and right that put the head where the tail hangs are asked about") {
  const bool areSwapped = GENERATE(false, true);
  SyntheticBiped body = makeHorse();
  // A horn rises beyond the head, and is of the head.
  body.joints.push_back({"horn", "head", jointOf(body, "head").position + Vec3(0.0, 1.0, 0.1)});
  std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key.starts_with("ear"); });
  for (std::size_t i = 0; i < body.joints.size(); ++i) {
    const std::string& key = body.joints[i].key;
    const bool isLeft = key.ends_with(".l");
    const char* const side = !isLeft && !key.ends_with(".r") ? "" : isLeft != areSwapped ? "_L" : "_R";
    body.names[key] = "Bone." + std::to_string(100 + i) + side;
  }
  const Body read = detectBody(build(body).scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(warnsOf(read, "put the head at an end that hangs") == areSwapped);
}

namespace {

/// A beast of blocks: each leg is one joint that turns a whole block, and the body carries all.
SyntheticBiped beastOfBlocks() {
  SyntheticBiped body;
  body.tubes = true;
  const auto add = [&](const std::string& key, const std::string& parent, const Vec3& place,
                       const Vec3& flesh) {
    body.joints.push_back({key, parent, place});
    body.joints.back().flesh = flesh;
    body.names[key] = key;
  };
  add("body", "", {0.0, 0.9, 0.0}, {0.0, 0.0, 0.4});
  add("head", "body", {0.0, 1.1, 0.5}, {0.0, 0.0, 0.3});
  int number = 0;
  for (const double z : {-0.4, 0.4}) {
    for (const double x : {-0.2, 0.2}) {
      add("leg" + std::to_string(number++), "body", {x, 0.75, z}, {0.0, -0.75, 0.0});
    }
  }
  return body;
}

} // namespace

TEST_CASE("A leg of one joint reaches as far as its block, where names call it a leg") {
  SyntheticBiped body = beastOfBlocks();
  body.rigid = GENERATE(false, true);
  body.withSkin = !body.rigid;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(read.planConfidence >= 0.8);
  for (const auto& [place, joint] : {std::pair(LimbPlace{LimbKind::leg, LimbSide::left, 1}, "leg3"),
                                     {LimbPlace{LimbKind::leg, LimbSide::right, 1}, "leg2"},
                                     {LimbPlace{LimbKind::leg, LimbSide::left, 2}, "leg1"},
                                     {LimbPlace{LimbKind::leg, LimbSide::right, 2}, "leg0"}}) {
    const Limb* const leg = limbAt(read.limbs, place);
    REQUIRE(leg != nullptr);
    CHECK(describe(built, read, place) == std::string(joint) + " -> estimated");
    CHECK(leg->restLength == Approx(0.75).margin(0.1));
  }
}

TEST_CASE("Wings of several joints leave legs of one joint alone") {
  SyntheticBiped body = beastOfBlocks();
  for (const auto& [side, sign] : sides) {
    std::string above = "body";
    for (int i = 0; i < 3; ++i) {
      const std::string key = "wing" + std::to_string(i) + side;
      body.joints.push_back({key, above, {(0.2 + 0.3 * i) * sign, 1.0, 0.1}});
      body.names[key] = key;
      above = key;
    }
  }
  const Body read = detectBody(build(body).scene);
  CHECK(read.plan == "quadruped");
  CHECK(limbAt(read.limbs, {LimbKind::leg, LimbSide::left, 2}) != nullptr);
  CHECK(limbAt(read.limbs, {LimbKind::wing, LimbSide::left}) != nullptr);
}

TEST_CASE("Beside legs of several joints one that is called a limb and is one joint is none") {
  SyntheticBiped body = makeHorse();
  for (const auto& [side, sign] : sides) {
    body.joints.push_back({"plate" + side, "spine1", {0.3 * sign, 1.3, 0.0}});
    body.joints.back().flesh = Vec3(0.2 * sign, -1.2, 0.0);
    body.names["plate" + side] = "leg_armour" + side;
  }
  for (SyntheticJoint& joint : body.joints) {
    body.names.try_emplace(joint.key, joint.key);
  }
  body.tubes = true;
  for (const auto& [side, sign] : sides) {
    body.joints.push_back({"feather" + side, "hips", {0.2 * sign, 1.4, -0.9}});
    body.joints.back().flesh = Vec3(0.3 * sign, 0.5, -0.9);
    body.names["feather" + side] = "tailFeather" + side;
  }
  const Body read = detectBody(build(body).scene);
  CHECK(read.plan == "quadruped");
  CHECK(limbAt(read.limbs, {LimbKind::leg, LimbSide::left, 3}) == nullptr);
  CHECK(limbAt(read.limbs, {LimbKind::wing, LimbSide::left}) == nullptr);
}

TEST_CASE("A root on the ground is no joint of a trunk, and what is a trunk by it alone is doubted") {
  const bool hasTrunk = GENERATE(true, false);
  SyntheticBiped body = makeHorse();
  SyntheticJoint root{"root", "", {0.0, 0.0, 0.2}};
  root.movesMesh = false;
  body.joints.insert(body.joints.begin(), root);
  // Neck and front legs hang from the root as well, and the trunk runs back to the hips.
  for (SyntheticJoint& joint : body.joints) {
    joint.parent = joint.parent == "spine1" ? "root" : joint.parent;
  }
  for (const auto& [joint, parent] :
       {std::pair("spine1", "root"), {"spine0", "spine1"}, {"hips", "spine0"}}) {
    jointOf(body, joint).parent = parent;
  }
  if (!hasTrunk) { // All hangs from the root.
    for (SyntheticJoint& joint : body.joints) {
      joint.parent =
          joint.parent == "hips" || joint.parent == "spine1" || joint.key == "hips" ? "root" : joint.parent;
    }
    std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key.starts_with("spine"); });
  }
  for (SyntheticJoint& joint : body.joints) {
    body.names[joint.key] = joint.key;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  const Limb* const spine = limbAt(read.limbs, biped::spine);
  if (hasTrunk) {
    CHECK(describe(built, read, biped::spine) == "spine1 spine0 -> hips");
    CHECK(spine->confidence >= 0.8);
  } else {
    CHECK((spine == nullptr || spine->confidence < 0.5));
  }
}

TEST_CASE("A beast on a slope is read as one on level ground, with names and without") {
  const auto leaning = [](SyntheticBiped body, double fore, double aside) {
    const Quat turn = axisAngle(Vec3(1.0, 0.0, 0.0), fore) * axisAngle(Vec3(0.0, 0.0, 1.0), aside);
    for (SyntheticJoint& joint : body.joints) {
      joint.position = turn * joint.position;
    }
    return body;
  };
  SyntheticBiped horse = makeHorse();
  nameByKeys(horse);
  SyntheticBiped insect = makeManyLegged(3);
  const auto [fore, aside] = GENERATE(std::pair(0.2, 0.0), std::pair(-0.2, 0.0), std::pair(0.0, 0.2));
  CAPTURE(fore, aside);
  checkHorse(leaning(horse, fore, aside));
  CHECK_FALSE(warnsOf(detectBody(build(leaning(horse, fore, aside)).scene), "leans"));
  const Body read = detectBody(build(leaning(insect, fore, aside)).scene);
  CHECK(read.plan == "insect");
  CHECK(warnsOf(read, "leans in its bind pose")); // no names tell
}

TEST_CASE("A leg begins at the joint that is called its upper arm, however short its bone is") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  for (const std::string& side : {std::string(".l"), std::string(".r")}) {
    jointOf(body, "scapula" + side).position =
        jointOf(body, "forearmLeg" + side).position + Vec3(0.0, 0.1, 0.0);
    body.names["scapula" + side] = (side == ".l" ? "Left" : "Right") + std::string("UpperArm");
    body.names["forearmLeg" + side] = (side == ".l" ? "Left" : "Right") + std::string("Arm");
  }
  checkHorse(body);
  for (const std::string& side : {std::string(".l"), std::string(".r")}) {
    body.names["scapula" + side] = "bone";
  }
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), frontLeft) ==
        "forearmLeg.l frontKnee.l frontPastern.l -> frontHoof.l");
}

TEST_CASE("What is called a head in the middle of all legs tells no front, one ahead of them does") {
  SyntheticBiped body = makeManyLegged(3);
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key.starts_with("tail") || joint.key.starts_with("antenna") || joint.key == "body";
  });
  jointOf(body, "thorax").parent = "";
  for (const SyntheticJoint& joint : body.joints) {
    body.names[joint.key] = joint.key.ends_with(".l") || joint.key.ends_with(".r") ? "leg" : "bone";
  }
  const bool isInMiddle = GENERATE(true, false);
  if (isInMiddle) {
    std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key == "head"; });
    jointOf(body, "thorax").position.z = 0.076; // where the legs are on the whole
    body.names["thorax"] = "tag_head";
  } else {
    body.names["head"] = "head";
  }
  const Body read = detectBody(build(body).scene);
  CHECK(read.plan == "insect");
  CHECK(warnsOf(read, "nothing tells which end of the body is the head") == isInMiddle);
}

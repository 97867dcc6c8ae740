// Bodies whose names tell what their shape leaves open: what stands beside their limbs, and where these
// begin.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct NamedJoint {
  std::string key;
  std::string parent; // with "%" where the side stands
  Vec3 place;         // on the left
};

void addCalled(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  body.joints.push_back({key, parent, place});
  body.names[key] = key;
}

// Called by their keys, on both sides.
void addCalledPairs(SyntheticBiped& body, const std::vector<NamedJoint>& joints) {
  for (const auto& [side, sign] : sides) {
    for (const NamedJoint& joint : joints) {
      std::string parent = joint.parent;
      if (const std::size_t mark = parent.find('%'); mark != std::string::npos) {
        parent.replace(mark, 1, side);
      }
      addCalled(body, joint.key + side, parent, {sign * joint.place.x, joint.place.y, joint.place.z});
    }
  }
}

void drop(SyntheticBiped& body, const std::vector<std::string>& stems) {
  std::erase_if(body.joints, [&](const SyntheticJoint& joint) {
    return std::ranges::any_of(stems, [&](const std::string& stem) { return joint.key.starts_with(stem); });
  });
}

// Everything is called by its key.
SyntheticBiped namedPerson() {
  SyntheticBiped body = makeBody({.fingers = false});
  nameByKeys(body);
  return body;
}

} // namespace

TEST_CASE("What hangs beside the named legs of a named beast makes no insect of it") {
  for (const double lowest : {0.05, 0.3, 0.55}) {
    CAPTURE(lowest);
    SyntheticBiped body = makeHorse();
    nameByKeys(body);
    addCalledPairs(body, {{"barding0", "spine0", {0.3, 1.25, -0.2}},
                          {"barding1", "barding0%", {0.36, 0.9, -0.2}},
                          {"barding2", "barding1%", {0.36, lowest, -0.2}}});
    const BuiltBiped built = build(body);
    const Body read = detectBody(built.scene);
    CHECK(read.plan == "quadruped");
    CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}) ==
          "scapula.l forearmLeg.l frontKnee.l frontPastern.l -> frontHoof.l");
    CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 2}) ==
          "thigh.l calf.l hock.l pastern.l -> hoof.l");
  }
}

TEST_CASE("A person who sits on a chair with named legs stays one") {
  SyntheticBiped body = namedPerson();
  addCalled(body, "Throne", "root", {0.0, 0.5, -0.3});
  addCalledPairs(body, {{"Throne_Leg_Front", "Throne", {0.35, 0.45, 0.2}},
                        {"Throne_Leg_Front_end", "Throne_Leg_Front%", {0.35, 0.0, 0.2}},
                        {"Throne_Leg_Back", "Throne", {0.35, 0.45, -0.5}},
                        {"Throne_Leg_Back_end", "Throne_Leg_Back%", {0.35, 0.0, -0.5}}});
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE("Limbs of many equal bones begin at the first") {
  const int bones = GENERATE(3, 5, 7, 10, 16);
  CAPTURE(bones);
  SyntheticBiped body = namedPerson();
  drop(body, {"upperArm", "foreArm", "thigh", "shin", "toe"});
  for (const auto& [side, sign] : sides) {
    std::string arm = "clavicle" + side;
    std::string leg = "hips";
    for (int i = 0; i < bones; ++i) {
      const double share = static_cast<double>(i) / bones;
      addCalled(body, "arm" + std::to_string(i) + side, arm, {sign * (0.18 + 0.52 * share), 1.43, -0.02});
      addCalled(body, "leg" + std::to_string(i) + side, leg, {sign * 0.1, 0.92 - 0.83 * share, 0.0});
      arm = "arm" + std::to_string(i) + side;
      leg = "leg" + std::to_string(i) + side;
    }
    jointOf(body, "hand" + side).parent = arm;
    jointOf(body, "foot" + side).parent = leg;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  for (const LimbPlace& place : {biped::leftArm, biped::rightArm}) {
    CHECK(describe(built, read, place).starts_with("arm0"));
  }
  for (const LimbPlace& place : {biped::leftLeg, biped::rightLeg}) {
    CHECK(describe(built, read, place).starts_with("leg0"));
  }
}

TEST_CASE("A leg of an upper, a middle and a lower bone begins at the upper one") {
  SyntheticBiped body = namedPerson();
  drop(body, {"thigh", "shin"});
  addCalledPairs(body, {{"Leg_Upper", "hips", {0.19, 0.92, 0.0}},
                        {"Leg_Mid", "Leg_Upper%", {0.24, 0.68, 0.24}},
                        {"Leg_Lower", "Leg_Mid%", {0.24, 0.34, -0.22}}});
  for (const auto& [side, sign] : sides) {
    jointOf(body, "foot" + side).parent = "Leg_Lower" + side;
    jointOf(body, "foot" + side).position = {sign * 0.24, 0.06, 0.02};
    jointOf(body, "toe" + side).position = {sign * 0.24, 0.02, 0.19};
  }
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), biped::leftLeg).starts_with("Leg_Upper.l "));
}

TEST_CASE("Of the hinges of a robot's hip the leg begins at the first with a bone that goes down") {
  SyntheticBiped body = namedPerson();
  drop(body, {"thigh"});
  const bool isAside = GENERATE(false, true);
  addCalledPairs(body, {{"hip_pitch", "hips", {isAside ? 0.04 : 0.1, 0.93, 0.0}},
                        {"hip_roll", "hip_pitch%", {0.1, 0.92, 0.0}},
                        {"hip_yaw", "hip_roll%", {0.1, 0.8, 0.0}}});
  for (const auto& [side, sign] : sides) {
    jointOf(body, "shin" + side).parent = "hip_yaw" + side;
  }
  const BuiltBiped built = build(body);
  const std::string leg = describe(built, detectBody(built.scene), biped::leftLeg);
  CAPTURE(leg);
  CHECK((leg.starts_with("hip_roll.l ") || (!isAside && leg.starts_with("hip_pitch.l "))));
}

TEST_CASE("A beast whose quarters hang from one joint is mirrored across its named head, however it faces") {
  const double degrees = GENERATE(0.0, 37.0, 90.0, -90.0);
  CAPTURE(degrees);
  SyntheticBiped body;
  for (const auto& [key, parent, place] : std::vector<NamedJoint>{{"Body", "", {0.0, 0.9, 0.0}},
                                                                  {"Chest", "Body", {0.0, 0.9, 0.35}},
                                                                  {"Neck", "Chest", {0.0, 1.0, 0.55}},
                                                                  {"Head", "Neck", {0.0, 1.2, 0.8}},
                                                                  {"Hip", "Body", {0.0, 0.9, -0.35}},
                                                                  {"Tail1", "Hip", {0.0, 0.9, -0.5}},
                                                                  {"Tail2", "Tail1", {0.0, 0.75, -0.65}}}) {
    addCalled(body, key, parent, place);
  }
  for (const auto& [end, parent, z] : {std::tuple("F", "Chest", 0.35), {"B", "Hip", -0.35}}) {
    for (const auto& [side, sign] : sides) {
      const std::string stem = std::string(end) + (sign > 0.0 ? "L" : "R") + "_leg";
      addCalled(body, stem + "1", parent, {sign * 0.2, 0.8, z});
      addCalled(body, stem + "2", stem + "1", {sign * 0.2, 0.4, z});
      addCalled(body, stem + "3", stem + "2", {sign * 0.2, 0.03, z});
    }
  }
  body.turn = axisAngle(Vec3(0.0, 1.0, 0.0), degrees * pi / 180.0);
  body.tubes = true;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}).starts_with("FL_leg1 "));
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::right, 2}).starts_with("BR_leg1 "));
}

TEST_CASE("Of joints that are called head the one above the arms is") {
  SyntheticBiped body = namedPerson();
  SECTION("beside what the head looks at") {
    addCalled(body, "Head_Look", "root", {0.0, 1.6, 0.5});
  }
  SECTION("beside a hood on the chest") {
    addCalled(body, "Head_Hood", "spine2", {0.0, 1.5, -0.1});
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::neck) == "neck0 -> head");
}

TEST_CASE("Of four named arms those without a number or nearer the head are taken, and the others told") {
  const bool isNumbered = GENERATE(true, false);
  SyntheticBiped body = namedPerson();
  const std::string end = isNumbered ? "2" : "Below";
  addCalledPairs(body, {{"clavicle" + end, "spine2", {0.03, 1.2, 0.01}},
                        {"upperArm" + end, "clavicle" + end + "%", {0.18, 1.2, -0.02}},
                        {"foreArm" + end, "upperArm" + end + "%", {0.45, 1.2, -0.03}},
                        {"hand" + end, "foreArm" + end + "%", {0.7, 1.2, -0.02}},
                        {"grip" + end, "hand" + end + "%", {0.8, 1.2, -0.02}}});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(warnsOf(read, "another pair of arms"));
}

TEST_CASE("A tail ends where it parts in two, and that of a body without legs may coil") {
  SyntheticBiped body = namedPerson();
  SECTION("in two") {
    addCalled(body, "Tail0", "hips", {0.0, 0.9, -0.1});
    addCalled(body, "Tail1", "Tail0", {0.0, 0.7, -0.3});
    addCalled(body, "Tail2", "Tail1", {0.0, 0.5, -0.5});
    addCalledPairs(body, {{"Spade", "Tail2", {0.1, 0.45, -0.6}}});
    const BuiltBiped built = build(body);
    CHECK(describe(built, detectBody(built.scene), {LimbKind::tail}) == "Tail0 Tail1 -> Tail2");
  }
  SECTION("coiled") {
    drop(body, {"thigh", "shin", "foot", "toe"});
    addCalled(body, "coil0", "hips", {0.0, 0.6, -0.05});
    for (int i = 1; i < 7; ++i) {
      addCalled(body, "coil" + std::to_string(i), "coil" + std::to_string(i - 1),
                {i % 2 == 0 ? 0.1 : -0.1, 0.1, -0.25 * i});
    }
    const BuiltBiped built = build(body);
    CHECK(describe(built, detectBody(built.scene), {LimbKind::tail}).starts_with("coil0 coil1 "));
  }
}

TEST_CASE("A body of many named legs about one joint has its abdomen behind, and no eye for a head") {
  SyntheticBiped body = makeManyLegged(4);
  drop(body, {"thorax", "head", "tail", "antenna"});
  for (SyntheticJoint& joint : body.joints) {
    joint.parent = joint.parent == "thorax" ? "body" : joint.parent;
  }
  nameByKeys(body);
  const bool isSpider = GENERATE(true, false);
  if (isSpider) {
    addCalled(body, "Abdomen0", "body", {0.0, 0.4, -0.5});
    addCalled(body, "Abdomen1", "Abdomen0", {0.0, 0.45, -0.9});
    addCalledPairs(body,
                   {{"Pedipalp0", "body", {0.08, 0.4, 0.3}}, {"Pedipalp1", "Pedipalp0%", {0.1, 0.3, 0.6}}});
  } else {
    addCalledPairs(body, {{"Eye", "body", {0.08, 0.5, 0.3}}});
  }
  body.turn = axisAngle(Vec3(0.0, 1.0, 0.0), GENERATE(0.0, pi));
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "spider");
  if (isSpider) {
    CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}) == "femur0.l tibia0.l -> tarsus0.l");
  }
  CHECK(findLimb(read, biped::spine) == nullptr);
}

TEST_CASE("A named person whose arms reach the ground it lies on stays one, and is doubted") {
  SyntheticBiped body = namedPerson();
  for (const auto& [side, sign] : sides) {
    jointOf(body, "foreArm" + side).position = {sign * 0.37, 1.24, -0.05};
    jointOf(body, "hand" + side).position = {sign * 0.54, 1.06, -0.08};
    jointOf(body, "shin" + side).position.z = -0.015;
  }
  body.turn = axisAngle(Vec3(1.0, 0.0, 0.0), -pi / 2.0);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(warnsOf(read, "the body lies"));
}

TEST_CASE("An insect's front legs are no arms of a person") {
  SyntheticBiped body = makeManyLegged(3);
  nameByKeys(body);
  const std::vector<std::string> rows{"LegFront", "LegMid", "LegBack"};
  for (const auto& [side, sign] : sides) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      int number = 1;
      for (const char* const part : {"coxa", "femur", "tibia", "tarsus"}) {
        body.names[part + std::to_string(row) + side] = rows[row] + std::to_string(number++) + side;
      }
    }
  }
  const Body read = detectBody(build(body).scene);
  CHECK(read.plan == "insect");
  CHECK(read.planConfidence > 0.5);
}

TEST_CASE("A joint of the face in the head's own place does not tell where it points") {
  SyntheticBiped body = namedPerson();
  addCalled(body, "Face_Root", "head", jointOf(body, "head").position + Vec3(0.0, 0.0, -1e-6));
  addCalledPairs(body, {{"Eye", "Face_Root", {0.03, 1.66, 0.1}}});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(!warnsOf(read, "point the other way"));
  CHECK(findLimb(read, biped::leftArm)->confidence > 0.9);
}

TEST_CASE("A body that is all legs is a biped where these are named and carry it") {
  SyntheticBiped body = namedPerson();
  drop(body, {"clavicle", "upperArm", "foreArm", "hand", "spine", "neck", "head"});
  jointOf(body, "hips").movesMesh = true;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.isBiped);
  CHECK(findLimb(read, biped::leftLeg)->confidence > 0.8);
}

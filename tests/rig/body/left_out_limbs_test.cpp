// What is called a limb and is in none is told; and legs that names call by row and side are of these.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/body/evidence/name_evidence.h"
#include "rig/body/evidence/name_text.h"
#include "rig/body/reading/detection.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

SyntheticBiped namedPerson() {
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  body.tubes = true;
  return body;
}

// A row of joints behind another one, of which the first is called so.
void addRow(SyntheticBiped& body, const std::string& called, const std::string& parent, double length = 0.9) {
  std::string above = parent;
  Vec3 place = jointOf(body, parent).position;
  for (int i = 0; i < 3; ++i) {
    place -= Vec3(0.0, 0.0, length / 3.0);
    const std::string key = "row" + std::to_string(i);
    body.joints.push_back({key, above, place});
    body.names[key] = called + (i == 0 ? "" : "_" + std::to_string(i));
    above = key;
  }
}

bool tellsLeftOut(const SyntheticBiped& body, const std::string& name) {
  return warnsOf(detectBody(build(body).scene), "left out, though called limbs: " + name + ";");
}

/// A beast whose legs are called by letters of their rows and sides.
SyntheticBiped lettered(const std::vector<std::string>& letters) {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  for (auto& [key, name] : body.names) {
    const bool isFront =
        key.starts_with("scapula") || key.starts_with("forearmLeg") || key.starts_with("front");
    const bool isHind = key.starts_with("thigh") || key.starts_with("calf") || key.starts_with("hock") ||
                        key.starts_with("pastern") || key.starts_with("hoof");
    if (isFront || isHind) {
      const std::size_t row = isFront ? 0 : 2;
      const std::string stem = key.substr(0, key.size() - 2);
      name = "leg_" + letters[row + (key.ends_with(".r") ? 1 : 0)] + "_" + stem;
    }
  }
  return body;
}

} // namespace

TEST_CASE("A limb too many is told by the name of its first joint") {
  const std::string called = GENERATE("third_arm", "middle_leg", "Wing");
  SyntheticBiped body = namedPerson();
  addRow(body, called, "spine1");
  CHECK(tellsLeftOut(body, called));
  SyntheticBiped near = namedPerson();
  addRow(near, called, "spine1", 0.05); // it may be a part of the trunk
  CHECK_FALSE(warnsOf(detectBody(build(near).scene), "though called limbs"));
}

TEST_CASE("What is found, worn, held or a handle is no limb left out") {
  SyntheticBiped body = namedPerson();
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "though called limbs"));
  const auto [called, parent] = GENERATE(
      std::pair<std::string, std::string>("Tail", "head"), std::pair("hair_tail", "spine1"),
      std::pair("PonyTail", "spine1"), std::pair("pony_tail", "spine1"), std::pair("coat_tail", "spine1"),
      std::pair("cape_wing", "spine1"), std::pair("belt_feather", "spine1"), std::pair("feather", "spine1"),
      std::pair("arm_blade", "hand.r"), std::pair("IK_Arm", "spine1"), std::pair("LeftArmTwist", "spine1"),
      std::pair("arm_armour", "spine1"), std::pair("Abdomen", "spine1"), std::pair("pectoral", "spine1"),
      std::pair("Tail", "hips"));
  CAPTURE(called, parent);
  addRow(body, called, parent);
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "though called limbs"));
}

TEST_CASE("One joint is a limb left out where all words of its name are known, a row in any case") {
  const auto [called, isLimb] =
      GENERATE(std::pair<std::string, bool>("Left_Arm", true), std::pair("thigh_plate", false),
               std::pair("wing_mirror", false), std::pair("leg_L", true));
  CAPTURE(called);
  SyntheticBiped lone = namedPerson();
  lone.joints.push_back({"lone", "spine1", jointOf(lone, "spine1").position - Vec3(0.0, 0.0, 0.6)});
  lone.names["lone"] = called;
  CHECK(tellsLeftOut(lone, called) == isLimb);
  SyntheticBiped row = namedPerson();
  addRow(row, called, "spine1");
  CHECK(tellsLeftOut(row, called));
}

TEST_CASE("Fins of what has no arms, and an abdomen on six legs, are limbs left out") {
  SyntheticBiped beast = makeHorse();
  nameByKeys(beast);
  beast.joints.push_back({"sail", "spine1", jointOf(beast, "spine1").position + Vec3(0.0, 1.0, 0.0)});
  beast.names["sail"] = "dorsal_fin";
  CHECK(tellsLeftOut(beast, "dorsal_fin"));
  SyntheticBiped insect = makeManyLegged(3);
  nameByKeys(insect);
  insect.joints.push_back({"second", "thorax", {0.0, 1.4, -0.6}});
  insect.names["second"] = "abdomen";
  CHECK(tellsLeftOut(insect, "abdomen"));
}

TEST_CASE("Of a second person and of a copy of the skeleton the limbs are not told one by one") {
  SyntheticBiped two = namedPerson();
  const bool isApart = GENERATE(true, false);
  addOther(two, namedPerson(), isApart ? Vec3(1.3, 0.0, 0.2) : Vec3(0.0));
  const Body read = detectBody(build(two).scene);
  CHECK(warnsOf(read, isApart ? "characters in the file" : "more than one skeleton"));
  CHECK_FALSE(warnsOf(read, "though called limbs"));
}

TEST_CASE("Of many limbs left out the first are named and the others counted") {
  SyntheticBiped body = namedPerson();
  for (int i = 0; i < 11; ++i) {
    const std::string key = "tail" + std::to_string(i);
    body.joints.push_back({key, "hips", {0.1 * i - 0.5, 0.9, -0.7}});
    body.names[key] = key;
  }
  const Body read = detectBody(build(body).scene);
  CHECK(warnsOf(read, " more; choose chains of joints"));
  CHECK_FALSE(warnsOf(read, "tail9"));
}

TEST_CASE("Wings of a person are told, and a bird's feathers that hang beside its wings are not") {
  SyntheticBiped person = namedPerson();
  SyntheticBiped bird = makeBird();
  nameByKeys(bird);
  for (const auto& [side, sign] : sides) {
    const std::string called = side == ".l" ? "WingLeft" : "WingRight";
    person.joints.push_back({"wing" + side, "spine2", {sign * 0.3, 1.4, -0.3}});
    person.joints.push_back({"wingTip" + side, "wing" + side, {sign * 0.9, 1.5, -0.5}});
    person.names["wing" + side] = called;
    person.names["wingTip" + side] = called + "1";
    bird.joints.push_back({"feather" + side, "spine0", {sign * 1.2, 2.0, -1.0}});
    bird.names["feather" + side] = "wing_feather" + side;
  }
  CHECK(warnsOf(detectBody(build(person).scene), "left out, though called limbs: WingLeft, WingRight;"));
  const Body read = detectBody(build(bird).scene);
  CHECK(findLimb(read, {LimbKind::wing, LimbSide::left}) != nullptr);
  CHECK_FALSE(warnsOf(read, "though called limbs"));
}

TEST_CASE("A neck by its name on which the front legs hang is told, and is none of them") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key == "neck1"; });
  jointOf(body, "head").parent = "neck0";
  const bool hangOnNeck = GENERATE(true, false);
  for (const auto& [side, sign] : sides) {
    jointOf(body, "scapula" + side).parent = hangOnNeck ? "neck0" : "spine1";
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "quadruped");
  CHECK(warnsOf(read, "no neck found, though neck0 is called one") == hangOnNeck);
  CHECK(describe(built, read, biped::neck) == (hangOnNeck ? "none" : "neck0 -> head"));
}

TEST_CASE("A hand of no telling name under a root that moves nothing ends its arm where the mesh does") {
  SyntheticBiped body = namedPerson();
  for (const auto& [side, sign] : sides) {
    const Vec3 hand = jointOf(body, "hand" + side).position;
    jointOf(body, "foreArm" + side).flesh = 0.95 * (hand - jointOf(body, "foreArm" + side).position);
    jointOf(body, "hand" + side).parent = "root";
    body.names["hand" + side] = side == ".l" ? "Bone_L.009" : "Bone_R.009";
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, read, biped::rightArm) == "upperArm.r foreArm.r -> hand.r");
}

TEST_CASE("An arm without a hand that hangs down to the hip ends at itself") {
  SyntheticBiped body = makeNamedBody("Mixamo", {.hands = false, .fingers = false});
  body.tubes = true;
  for (const auto& [side, sign] : sides) {
    const Vec3 hip = jointOf(body, "thigh" + side).position;
    jointOf(body, "upperArm" + side).position = {sign * 0.2, 1.4, 0.0};
    jointOf(body, "foreArm" + side).position = {sign * 0.22, 1.12, 0.0};
    jointOf(body, "foreArm" + side).flesh = 0.9 * (hip - jointOf(body, "foreArm" + side).position);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> estimated");
  CHECK(describe(built, read, biped::rightArm) == "upperArm.r foreArm.r -> estimated");
}

TEST_CASE("Letters of row and side call legs left and right, whichever way the body faces") {
  const auto letters = GENERATE(values<std::vector<std::string>>(
      {{"fl", "fr", "bl", "br"}, {"LF", "RF", "LH", "RH"}, {"FL", "FR", "RL", "RR"}}));
  CAPTURE(letters.front());
  SyntheticBiped body = lettered(letters);
  body.facesBackwards = GENERATE(false, true);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}).starts_with("scapula.l "));
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::right, 2}).starts_with("thigh.r "));
  CHECK_FALSE(warnsOf(read, "right?"));
  SyntheticBiped against = lettered({letters[1], letters[0], letters[3], letters[2]});
  CHECK(warnsOf(detectBody(build(against).scene), "right?"));
}

TEST_CASE("Two letters of row and side tell a pair's joints alike, and others tell nothing") {
  using namespace stretch::rig::body;
  for (const auto& [left, right] :
       {std::pair("leg_fl", "leg_fr"), std::pair("leg_LF", "leg_RF"), std::pair("legML", "legMR")}) {
    CAPTURE(left);
    CHECK(readName(left).side == Side::left);
    CHECK(readName(right).side == Side::right);
    CHECK(readName(left).key == readName(right).key);
  }
  CHECK(readName("Lf_Arm").key == readName("Rt_Arm").key); // sides alone
  CHECK(readName("leg_fl").key != readName("leg_bl").key);
  CHECK(readName("leg_LH").key != readName("leg_LF").key);
  CHECK_FALSE(rowLetters("lf"));
  CHECK(readName("box_fl").side == Side::none); // no limb
  CHECK_FALSE(rowLetters("lr"));
  CHECK_FALSE(rowLetters("f"));
  CHECK_FALSE(rowLetters("tl"));
  CHECK_FALSE(rowLetters("flx"));
  CHECK(rowLetters("rl")->row == 'r');
  CHECK(rowLetters("lb")->row == 'b');
  CHECK(rowLetters("lb")->side == 'l');
}

TEST_CASE("Legs of a flat beast are front and hind ones by their names, and rows of letters stay in order") {
  SyntheticBiped flat;
  flat.joints = {{"torso", "", {0.0, 0.36, 0.0}}, {"head", "torso", {0.0, 0.62, 0.0}}};
  const bool isHindFirst = GENERATE(false, true);
  const bool areLfRt = GENERATE(false, true);
  for (const auto& [side, sign] : sides) {
    for (const auto& [row, x] :
         {std::pair(isHindFirst ? "hind" : "front", 0.08), std::pair(isHindFirst ? "front" : "hind", 0.18)}) {
      const std::string stem = row;
      flat.joints.push_back({stem + "_leg" + side, "torso", {sign * x, 0.34, 0.0}});
      flat.joints.push_back({stem + "_paw" + side, stem + "_leg" + side, {sign * (x + 0.02), 0.14, 0.0}});
    }
  }
  nameByKeys(flat);
  for (auto& [key, name] : flat.names) {
    if (areLfRt && key.size() > 2 && key[key.size() - 2] == '.') {
      name = key.substr(0, key.size() - 2) + (key.back() == 'l' ? "_Lf" : "_Rt");
    }
  }
  const BuiltBiped built = build(flat);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}).starts_with("front_leg.l"));
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::right, 2}).starts_with("hind_leg.r"));

  SyntheticBiped spider = makeManyLegged(4);
  nameByKeys(spider);
  const std::vector<std::string> parts{"coxa", "femur", "tibia", "tarsus"};
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t row = 0; row < 4; ++row) {
      for (const std::string side : {"l", "r"}) {
        spider.names[parts[part] + std::to_string(row) + "." + side] =
            std::string("leg_") + "abcd"[row] + "_" + std::to_string(part + 1) + "_" + side;
      }
    }
  }
  const BuiltBiped builtSpider = build(spider);
  const Body readSpider = detectBody(builtSpider.scene);
  for (int row = 1; row <= 4; ++row) {
    const std::string leg = describe(builtSpider, readSpider, {LimbKind::leg, LimbSide::left, row});
    CHECK(leg.ends_with("tarsus" + std::to_string(row - 1) + ".l"));
  }
}

TEST_CASE("A pelvis that carries no more than the spine on which the legs hang is the body's centre") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  const Vec3 hips = jointOf(body, "hips").position;
  const bool isNear = GENERATE(true, false);
  body.joints.insert(body.joints.begin(),
                     {"Bip01 Pelvis", "", isNear ? hips + Vec3(0.0, 0.02, 0.0) : hips - Vec3(0.0, 0.0, 1.4)});
  body.names["Bip01 Pelvis"] = "Bip01 Pelvis";
  jointOf(body, "hips").parent = "Bip01 Pelvis";
  body.names["hips"] = "Bip01 Spine";
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(keyOf(built, read.hips) == (isNear ? "Bip01 Pelvis" : "hips"));
}

TEST_CASE("A cervical vertebra is of the neck and no joint of the spine") {
  using namespace stretch::rig::body;
  const NameEvidence cervical = readName("vertebra_cervical_3");
  CHECK(cervical.role(Role::neck) == 1.0);
  CHECK(cervical.role(Role::spine) == 0.0);
  CHECK(cervical.role(Role::chest) == 0.0);
  CHECK(readName("vertebra_lumbar_3").role(Role::spine) == 1.0);
}

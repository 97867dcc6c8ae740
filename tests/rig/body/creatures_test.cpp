#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/body/reading/detection.h"
#include "rig/body/reading/planned_body.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::string limbsOf(const BuiltBiped& built, const Body& body) {
  std::string text;
  for (const Limb& limb : body.limbs) {
    text += limb.id + ": " + describe(built, body, limb) + "\n";
  }
  return text;
}

const char* const horseLimbs =
    "front-left-leg: scapula.l forearmLeg.l frontKnee.l frontPastern.l -> frontHoof.l\n"
    "front-right-leg: scapula.r forearmLeg.r frontKnee.r frontPastern.r -> frontHoof.r\n"
    "hind-left-leg: thigh.l calf.l hock.l pastern.l -> hoof.l\n"
    "hind-right-leg: thigh.r calf.r hock.r pastern.r -> hoof.r\n"
    "spine: spine0 -> spine1\n"
    "neck: neck0 neck1 -> head\n"
    "tail: tail0 tail1 -> tail2\n";

} // namespace

TEST_CASE("Each sort of body is read as its plan, with names and without") {
  for (const Creature& creature : creatures()) {
    for (const bool named : {true, false}) {
      SyntheticBiped body = creature.body;
      if (!named) {
        body.names.clear();
      }
      CAPTURE(creature.title, named);
      const Body read = detectBody(build(body).scene);
      CHECK(read.plan == creature.plan);
      CHECK((read.planConfidence >= 0.5) == (creature.plan != "other")); // no plan that fits is a doubt
      CHECK_FALSE(read.planReasons.empty());
      CHECK_FALSE(read.isBiped);
    }
  }
}

TEST_CASE("A horse has four legs from the scapula or the hip to the hoof, a neck and a tail") {
  SyntheticBiped body = makeHorse();
  const bool named = GENERATE(true, false);
  if (named) {
    nameByKeys(body);
  }
  const BuiltBiped built = build(body);
  CHECK(limbsOf(built, detectBody(built.scene)) == horseLimbs);
}

TEST_CASE("Legs of an insect are counted from front to back, and its feelers are none") {
  SyntheticBiped body = makeManyLegged(3);
  const bool named = GENERATE(true, false);
  if (named) {
    nameByKeys(body);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}) == "femur0.l tibia0.l -> tarsus0.l");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::right, 3}) == "femur2.r tibia2.r -> tarsus2.r");
  CHECK(findLimb(read, {LimbKind::leg, LimbSide::left, 1})->id == "left-leg");
  CHECK(findLimb(read, {LimbKind::leg, LimbSide::right, 3})->id == "right-leg-3");
  CHECK(findLimb(read, {LimbKind::feeler, LimbSide::left}) != nullptr);
  CHECK(findLimb(read, {LimbKind::tail}) != nullptr);
}

TEST_CASE(
    "A joint more at one leg of an unnamed body on many legs changes no limb, on whichever side it is") {
  const int rows = GENERATE(3, 4);
  const std::string side = GENERATE(".l", ".r");
  const std::string hip = GENERATE("coxa0", "coxa1", "coxa2", "antenna0");
  const bool isSpur = GENERATE(true, false);
  CAPTURE(rows, side, hip, isSpur);
  SyntheticBiped body = makeManyLegged(rows);
  const BuiltBiped plain = build(body);
  const std::string coxa = hip + side;
  const Vec3 place = jointOf(body, coxa).position;
  if (isSpur) {
    body.joints.push_back({"spur", coxa, place + Vec3(side == ".l" ? 0.05 : -0.05, 0.12, 0.0)});
  } else {
    body.joints.push_back({"plate", jointOf(body, coxa).parent, place * Vec3(0.5, 1.0, 1.0)});
    jointOf(body, coxa).parent = "plate";
  }
  const BuiltBiped more = build(body);
  const Body read = detectBody(more.scene);
  CHECK(read.plan == detectBody(plain.scene).plan);
  CHECK(describe(more, read, biped::neck) == describe(plain, detectBody(plain.scene), biped::neck));
  CHECK(describe(more, read, {LimbKind::tail}) == "tail0 tail1 -> tail2");
  for (int leg = 1; leg <= rows; ++leg) {
    const std::string number = std::to_string(leg - 1);
    for (const auto& [at, name] : {std::pair(LimbSide::left, ".l"), std::pair(LimbSide::right, ".r")}) {
      CHECK(describe(more, read, {LimbKind::leg, at, leg}) ==
            "femur" + number + name + " tibia" + number + name + " -> tarsus" + number + name);
    }
  }
}

TEST_CASE("A bird has wings, and its legs stand on their toes") {
  SyntheticBiped body = makeBird();
  const bool named = GENERATE(true, false);
  if (named) {
    nameByKeys(body);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left}) == "thigh.l calf.l ankle.l -> toe.l");
  CHECK(describe(built, read, {LimbKind::wing, LimbSide::right}) == "wing0.r wing1.r wing2.r -> wing3.r");
  CHECK(describe(built, read, biped::neck) == "neck0 neck1 -> head");
}

TEST_CASE("A wing ends at its tip, not at a longer feather that hangs from it, however it is spelt") {
  const auto* const feather = GENERATE("wing_feather_1", "WINGFEATHER1", "WingFeather1");
  SyntheticBiped body = makeBird();
  nameByKeys(body);
  for (const auto& [side, sign] : {std::pair(".l", 1.0), std::pair(".r", -1.0)}) {
    const std::string key = std::string("feather") + side;
    body.joints.push_back({key, std::string("wing2") + side, {sign * 1.0, 0.2, 0.1}});
    body.names[key] = feather + std::string(side);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, {LimbKind::wing, LimbSide::left}) == "wing0.l wing1.l wing2.l -> wing3.l");
  CHECK(describe(built, read, {LimbKind::wing, LimbSide::right}) == "wing0.r wing1.r wing2.r -> wing3.r");
}

TEST_CASE("A body that lies or stands upside down in its bind pose is told, and read all the same") {
  SyntheticBiped body = makeHorse();
  const BuiltBiped upright = build(body);
  REQUIRE(detectBody(upright.scene).warnings.empty());
  SECTION("upside down") {
    body.turn = axisAngle(Vec3(0, 0, 1), pi);
  }
  SECTION("on its nose") {
    body.turn = axisAngle(Vec3(1, 0, 0), pi / 2.0);
  }
  SECTION("on its tail") {
    body.turn = axisAngle(Vec3(1, 0, 0), -pi / 2.0);
  }
  SECTION("on its side") {
    body.turn = axisAngle(Vec3(0, 0, 1), pi / 2.0);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "quadruped");
  CHECK(read.warnings.size() == 1);
  CHECK(limbsOf(built, read) == horseLimbs);
  const Body chosen = bodyAsPlan(built.scene, *planNamed("quadruped"));
  CHECK(limbsOf(built, chosen) == horseLimbs);
  CHECK(chosen.warnings.size() == 1);
}

TEST_CASE("The size of a body does not count") {
  for (const double size : {1e-4, 1e5}) {
    SyntheticBiped body = makeHorse();
    body.size = size;
    const BuiltBiped built = build(body);
    CAPTURE(size);
    CHECK(limbsOf(built, detectBody(built.scene)) == horseLimbs);
  }
}

TEST_CASE("A skeleton without a mesh is read as one with") {
  SyntheticBiped body = makeHorse();
  body.withMesh = false;
  const BuiltBiped built = build(body);
  CHECK(limbsOf(built, detectBody(built.scene)) == horseLimbs);
}

TEST_CASE("A person whose skin has no weights, with a rigid helmet, is no serpent") {
  SyntheticBiped body = makeBody();
  nameByKeys(body);
  body.withMesh = false;
  BuiltBiped built = build(body);
  Primitive helmet;
  helmet.positions = {{-0.1F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}, {0.0F, 0.2F, 0.1F}};
  const NodeIndex part = addNode(built.scene, "helmet", built.node.at("head"), Vec3(0.0));
  built.scene.nodes[at(part)].mesh = 0;
  built.scene.meshes.push_back({"helmet", {helmet}, {}});
  CHECK(detectBody(built.scene).plan != "serpent");
}

TEST_CASE("A serpent without a mesh keeps all of its joints") {
  SyntheticBiped body = makeSnake();
  for (int i = 0; i < 8; ++i) {
    const std::string last = i == 0 ? "head" : "tip" + std::to_string(i - 1);
    body.joints.push_back({"tip" + std::to_string(i), last, Vec3(0.0, 0.1, 1.44 + 0.14 * i)});
  }
  body.withMesh = false;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "serpent");
  REQUIRE(findLimb(read, biped::spine) != nullptr);
  CHECK(findLimb(read, biped::spine)->joints.size() >= 20);
}

TEST_CASE("A leg of one joint beside a longer one says nothing of where the feet point") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    const std::string& key = joint.key;
    return key == "calf.l" || key == "hock.l" || key == "pastern.l" || key == "hoof.l";
  });
  for (auto& [key, name] : body.names) { // each side is called the other one
    if (key.ends_with(".l") || key.ends_with(".r")) {
      name.back() = key.ends_with(".l") ? 'r' : 'l';
    }
  }
  CHECK_FALSE(bodyAsPlan(build(body).scene, *planNamed("quadruped")).limbs.empty());
}

TEST_CASE("A plan chosen by hand takes the only pair of legs that there is") {
  SyntheticBiped body = makeHorse();
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key.starts_with("front") || joint.key.starts_with("scapula") ||
           joint.key.starts_with("forearm");
  });
  const BuiltBiped built = build(body);
  const Body read = bodyAsPlan(built.scene, *planNamed("quadruped"));
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}) ==
        "thigh.l calf.l hock.l pastern.l -> hoof.l");
}

TEST_CASE("A plan that finds no limb says so, and leaves nothing of what was found without it") {
  SyntheticBiped body = makeSnake();
  for (SyntheticJoint& joint : body.joints) {
    joint.position = Vec3(0.0);
  }
  const Body none = bodyAsPlan(build(body).scene, *planNamed("serpent"));
  CHECK(none.limbs.empty());
  CHECK(none.warnings.size() == 1);
  CHECK_FALSE(bodyAsPlan(build(makeBody()).scene, *planNamed("quadruped")).isBiped);
}

TEST_CASE("A row of very many joints is no limb, whoever asks") {
  SyntheticBiped body;
  std::string parent;
  for (int i = 0; i < 320; ++i) {
    const std::string key = "segment" + std::to_string(i);
    body.joints.push_back({key, parent, Vec3(0.0, 0.06, 0.01 * i)});
    parent = key;
  }
  const Scene scene = build(body).scene;
  CHECK(detectBody(scene).limbs.empty());
  CHECK(bodyAsPlan(scene, *planNamed("serpent")).limbs.empty());
  CHECK(bodyAsPlan(scene, *planNamed("other")).limbs.empty());
}

TEST_CASE("A body of no known plan has the rows of joints between branchings") {
  SyntheticBiped body = makeCentaur();
  nameByKeys(body);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "other");
  CHECK(read.planConfidence < 0.5);
  CHECK(std::ranges::any_of(read.warnings,
                            [](const std::string& line) { return line.starts_with("no body plan fits"); }));
  std::vector<std::string> ids;
  for (const Limb& limb : read.limbs) {
    CHECK(limb.kind == LimbKind::chain);
    ids.push_back(limb.id);
  }
  CHECK(std::ranges::find(ids, "upperArm.l..hand.l") != ids.end());
  CHECK(std::ranges::find(ids, "thigh.r..hoof.r") != ids.end());
}

TEST_CASE("A plan chosen by hand is kept to, however well it fits") {
  const BuiltBiped built = build(makeHorse());
  const Body asOther = bodyAsPlan(built.scene, *planNamed("other"));
  CHECK(asOther.plan == "other");
  CHECK(asOther.planReasons == std::vector<std::string>{"chosen by hand"});
  CHECK(findLimb(asOther, {LimbKind::leg, LimbSide::left, 1}) == nullptr);
  const Body again = bodyAsPlan(built.scene, *planNamed("quadruped"));
  CHECK(limbsOf(built, again) == horseLimbs);
}

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/body/reading/detection.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/families/whole_rigs.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/rig/synthetic_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

SyntheticBiped bodyOfProgram(const std::string& title) {
  const WholeRig& rig =
      *std::ranges::find_if(wholeRigs(), [&](const WholeRig& one) { return one.scheme.title == title; });
  SyntheticBiped body = makeBody(optionsOf(rig));
  addHelpers(body, rig);
  return body;
}

void addPart(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  body.joints.push_back({key, parent, place});
  body.names[key] = key;
}

void addPartPair(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place,
                 bool bothParents) {
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    addPart(body, key + side, parent + (bothParents ? side : ""), {sign * place.x, place.y, place.z});
  }
}

// A body on two legs that bend forward at the knee and back at the heel.
SyntheticBiped onItsToes() {
  SyntheticBiped body;
  body.tubes = true;
  addPart(body, "hips", "", {0, 1.0, 0});
  addPart(body, "spine", "hips", {0, 1.3, 0});
  addPart(body, "head", "spine", {0, 1.7, 0});
  addPartPair(body, "upperLeg", "hips", {0.15, 0.95, 0}, false);
  addPartPair(body, "lowerLeg", "upperLeg", {0.15, 0.6, 0.2}, true);
  addPartPair(body, "ankle", "lowerLeg", {0.15, 0.32, -0.15}, true);
  addPartPair(body, "foot", "ankle", {0.15, 0.05, 0.0}, true);
  return body;
}

} // namespace

TEST_CASE("An arm ends at the hand that carries fingers, not at the helper called wrist in the same place") {
  const BuiltBiped built = build(bodyOfProgram("Source engine"));
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, read, biped::rightArm) == "upperArm.r foreArm.r -> hand.r");
}

TEST_CASE("The joint at which an arm ends may be called its end") {
  const BuiltBiped built = build(bodyOfProgram("mGear"));
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l -> foot.l");
}

TEST_CASE("What is called an end, moves the mesh and carries what does is a joint of its limb") {
  SyntheticBiped body = bodyOfProgram("Source engine");
  body.tubes = true;
  for (const auto& [side, sign] : sides) {
    body.names["hand" + side] = "hand_end" + side;
    body.names["foot" + side] = "foot_end" + side;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, read, biped::rightLeg) == "thigh.r shin.r -> foot.r");
}

TEST_CASE("Of two joints called head and neck the first is the neck") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  body.names["neck0"] = "head neck lower";
  body.names["head"] = "head neck upper";
  addPart(body, "head jaw", "head", {0, 1.62, 0.05});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::neck) == "neck0 -> head");
  CHECK(keyOf(built, read.head) == "head");
}

TEST_CASE(
    "A leg that stands on its toes goes on from the heel to the ground, one that is straight does not") {
  const BuiltBiped built = build(onItsToes());
  const Body read = detectBody(built.scene);
  CHECK(read.isBiped);
  CHECK(describe(built, read, biped::leftLeg) == "upperLeg.l lowerLeg.l ankle.l -> foot.l");
  CHECK(describe(built, read, biped::rightLeg) == "upperLeg.r lowerLeg.r ankle.r -> foot.r");
  SyntheticBiped flat = onItsToes();
  for (const std::string side : {".l", ".r"}) {
    jointOf(flat, "ankle" + side).position.y = 0.12;
    jointOf(flat, "ankle" + side).position.z = 0.0;
    jointOf(flat, "foot" + side).position.z = 0.15;
  }
  const BuiltBiped person = build(flat);
  CHECK(describe(person, detectBody(person.scene), biped::leftLeg) == "upperLeg.l lowerLeg.l -> ankle.l");
}

TEST_CASE("What stands upright on two legs with wings and no arms is a bird, an angel is a biped") {
  SyntheticBiped body = onItsToes();
  addPartPair(body, "wing", "spine", {0.15, 1.3, -0.05}, false);
  addPartPair(body, "wingMiddle", "wing", {0.25, 1.2, -0.2}, true);
  addPartPair(body, "wingTip", "wingMiddle", {0.3, 1.0, -0.35}, true);
  CHECK(detectBody(build(body).scene).plan == "bird");
  addPartPair(body, "upperArm", "spine", {0.2, 1.4, 0}, false);
  addPartPair(body, "lowerArm", "upperArm", {0.45, 1.35, 0}, true);
  addPartPair(body, "hand", "lowerArm", {0.7, 1.3, 0.02}, true);
  CHECK(detectBody(build(body).scene).plan == "biped");
}

TEST_CASE("A biped that has no arms is doubted more than one that has") {
  const Body read = detectBody(build(onItsToes()).scene);
  REQUIRE(read.isBiped);
  CHECK(read.planConfidence < 0.75);
  CHECK(std::ranges::any_of(read.planReasons, [](const std::string& reason) {
    return reason.find("no arms") != std::string::npos;
  }));
}

TEST_CASE("The trunk of a shark ends where its tail parts into fins") {
  SyntheticBiped body;
  body.tubes = true;
  std::string above;
  for (int i = 0; i < 7; ++i) {
    const std::string key = i == 0 ? "head" : "body" + std::to_string(i);
    addPart(body, key, above, {0, 0.6, 1.0 - 0.33 * i});
    above = key;
  }
  addPartPair(body, "fin", "body1", {0.2, 0.5, 0.5}, false);
  addPartPair(body, "finTip", "fin", {0.45, 0.42, 0.4}, true);
  addPart(body, "tailFinUp", "body6", {0, 0.95, -1.2});
  addPart(body, "tailFinLow", "body6", {0, 0.4, -1.1});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "serpent");
  const auto spine = std::ranges::find(read.limbs, std::string("spine"), &Limb::id);
  REQUIRE(spine != read.limbs.end());
  CHECK(keyOf(built, spine->endNode) != "tailFinUp");
  body.names.clear(); // without names nothing tells a fin from what goes on: that is said
  const Body unnamed = detectBody(build(body).scene);
  const auto guessed = std::ranges::find(unnamed.limbs, std::string("spine"), &Limb::id);
  REQUIRE(guessed != unnamed.limbs.end());
  CHECK(guessed->confidence < 0.5);
}

TEST_CASE("The trunk of a serpent ends at its head, whatever a face has beyond it") {
  SyntheticBiped body = makeSnake();
  nameByKeys(body);
  addPart(body, "jaw", "head", {0, 0.06, 1.34});
  const bool hasTongue = GENERATE(false, true);
  for (int i = 0; i < 3 && hasTongue; ++i) {
    addPart(body, "tongue" + std::to_string(i), i == 0 ? "head" : "tongue" + std::to_string(i - 1),
            {0, 0.08, 1.45 + 0.07 * i});
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "serpent");
  CHECK(describe(built, read, biped::spine).ends_with("segment15 -> head"));
}

TEST_CASE("The trunk of a fish ends where fins of two joints begin") {
  SyntheticBiped body = makeFish();
  nameByKeys(body);
  for (const auto& [fin, up] :
       {std::pair(std::string("tailFinUp"), 1.0), std::pair(std::string("tailFinLow"), -1.0)}) {
    addPart(body, fin + "0", "back7", {0, 1.0 + 0.1 * up, -1.1});
    addPart(body, fin + "1", fin + "0", {0, 1.0 + 0.2 * up, -1.18});
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "serpent");
  CHECK(describe(built, read, biped::spine).ends_with("back6 -> back7"));
}

TEST_CASE("Fins are no legs") {
  SyntheticBiped body;
  body.tubes = true;
  addPart(body, "body", "", {0, 0.5, 0});
  addPart(body, "chest", "body", {0, 0.5, 0.35});
  addPart(body, "head", "chest", {0, 0.5, 0.65});
  const std::string fin = GENERATE("pectoralFin", "flipper", "pectoral");
  addPartPair(body, fin + "0", "chest", {0.15, 0.42, 0.3}, false);
  addPartPair(body, fin + "1", fin + "0", {0.35, 0.32, 0.18}, true);
  addPartPair(body, fin + "2", fin + "1", {0.55, 0.22, 0.06}, true);
  for (int i = 0; i < 4; ++i) {
    addPart(body, "tail" + std::to_string(i), i == 0 ? "body" : "tail" + std::to_string(i - 1),
            {0, 0.5, -0.25 - 0.25 * i});
  }
  const Body read = detectBody(build(body).scene);
  CHECK_FALSE(read.isBiped);
  CHECK(std::ranges::none_of(read.limbs, [](const Limb& limb) { return isLeg(limb); }));
}

TEST_CASE(
    "Whose four legs are called arms and legs, and who lies, is doubted and told, with a tail or without") {
  SyntheticBiped body = bodyOfProgram("Arms by number");
  const bool hasTail = GENERATE(false, true);
  for (const std::string side : {".l", ".r"}) { // the arms reach forward, and the whole lies on its back
    const double sign = side == ".l" ? 1.0 : -1.0;
    jointOf(body, "foreArm" + side).position = {0.18 * sign, 1.43, 0.25};
    jointOf(body, "hand" + side).position = {0.18 * sign, 1.43, 0.5};
    jointOf(body, "shin" + side).position = {0.1 * sign, 0.8, 0.4};
    jointOf(body, "foot" + side).position = {0.1 * sign, 0.5, 0.1};
    jointOf(body, "toe" + side).position = {0.1 * sign, 0.42, 0.2};
  }
  for (int i = 0; i < 3 && hasTail; ++i) {
    const std::string above = i == 0 ? "hips" : "tail" + std::to_string(i - 1);
    addPart(body, "tail" + std::to_string(i), above,
            jointOf(body, "hips").position + Vec3(0, -0.15 * (i + 1), 0));
  }
  body.turn = axisAngle(Vec3(1, 0, 0), -pi / 2.0);
  body.withMesh = false;
  const Body read = detectBody(build(body).scene);
  CHECK((read.isBiped || (read.planConfidence < 0.5 && !read.warnings.empty())));
}

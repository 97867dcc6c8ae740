#include <catch2/catch.hpp>

#include "tests/support/rig/described_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const std::vector<std::pair<std::string, std::string>> table{{"hips", "hips"},
                                                             {"spine", "spine0"},
                                                             {"chest", "spine1"},
                                                             {"upperChest", "spine2"},
                                                             {"neck", "neck0"},
                                                             {"head", "head"},
                                                             {"leftUpperArm", "upperArm.r"},
                                                             {"leftLowerArm", "foreArm.r"},
                                                             {"leftHand", "hand.r"},
                                                             {"rightUpperArm", "upperArm.l"},
                                                             {"rightLowerArm", "foreArm.l"},
                                                             {"rightHand", "hand.l"},
                                                             {"leftUpperLeg", "thigh.r"},
                                                             {"leftLowerLeg", "shin.r"},
                                                             {"leftFoot", "foot.r"},
                                                             {"rightUpperLeg", "thigh.l"},
                                                             {"rightLowerLeg", "shin.l"},
                                                             {"rightFoot", "foot.l"}};

BuiltBiped withTable() {
  BuiltBiped built = build(makeBody());
  for (const auto& [bone, key] : table) {
    built.scene.humanoid[bone] = built.node.at(key);
  }
  return built;
}

} // namespace

TEST_CASE("the VRM humanoid table decides joints and sides, whatever names and feet say") {
  const BuiltBiped built = withTable();
  const Body biped = detectBody(built.scene);
  CHECK(biped.isBiped);
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.r foreArm.r -> hand.r");
  CHECK(describe(built, biped, biped::rightLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, biped, biped::spine) == "spine0 spine1 -> spine2");
  CHECK(describe(built, biped, biped::neck) == "neck0 -> head");
  CHECK(biped.hips == built.node.at("hips"));
  CHECK(biped.head == built.node.at("head"));
}

TEST_CASE("Nothing is asked that the humanoid table answers") {
  SyntheticBiped body = makeBody({.toes = false, .fingers = false});
  body.withMesh = false;
  for (SyntheticJoint& joint : body.joints) {
    joint.position.z = 0.0;
  }
  BuiltBiped built = build(body);
  REQUIRE_FALSE(detectBody(built.scene).warnings.empty());
  for (const auto& [bone, key] : table) {
    built.scene.humanoid[bone] = built.node.at(key);
  }
  const Body read = detectBody(built.scene);
  CHECK(read.warnings.empty());
  CHECK(read.planConfidence > 0.9);
}

TEST_CASE("a humanoid table without a neck has no neck limb, and a spine that ends at the head") {
  BuiltBiped built = withTable();
  for (const char* bone : {"neck", "chest", "upperChest"}) {
    built.scene.humanoid.erase(bone);
  }
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::neck) == "none");
  CHECK(describe(built, biped, biped::spine) == "spine0 -> head");
}

TEST_CASE(
    "of a humanoid table without a chest the spine ends at the neck, and all limbs are as sure as it is") {
  BuiltBiped built = withTable();
  for (const char* bone : {"chest", "upperChest"}) {
    built.scene.humanoid.erase(bone);
  }
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::spine) == "spine0 -> neck0");
  REQUIRE(biped.limbs.size() == 6);
  for (const Limb& limb : biped.limbs) {
    CHECK(limb.confidence > 0.95);
    CHECK(limb.reasons == std::vector<std::string>{"the VRM humanoid table of the file"});
  }
}

TEST_CASE(
    "an entry of the humanoid table that leads nowhere leaves the limb to the geometry, with a warning") {
  BuiltBiped built = withTable();
  built.scene.humanoid["leftHand"] = NodeIndex(9999);
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::rightArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.r foreArm.r -> hand.r");
  REQUIRE_FALSE(biped.warnings.empty());
  CHECK(biped.warnings.front().find("humanoid table names no complete left-arm") != std::string::npos);
}

TEST_CASE("a hand of the humanoid table that is not below its elbow leaves the arm to the geometry") {
  const std::string hand = GENERATE("foreArm.r", "hand.l"); // the elbow itself, and the other hand
  CAPTURE(hand);
  BuiltBiped built = withTable();
  built.scene.humanoid["leftHand"] = built.node.at(hand);
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.r foreArm.r -> hand.r");
  REQUIRE_FALSE(biped.warnings.empty());
  CHECK_THAT(biped.warnings.front(), Catch::Contains("humanoid table names no complete left-arm"));
}

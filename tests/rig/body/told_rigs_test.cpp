// What names, tables and plain shapes tell stays told, whatever is asked where they do not.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/body/reading/detection.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

void checkLegs(const BuiltBiped& built, const Body& read) {
  CHECK(describe(built, read, biped::leftLeg).starts_with("thigh.l shin.l "));
  CHECK(describe(built, read, biped::rightLeg).starts_with("thigh.r shin.r "));
}

} // namespace

TEST_CASE("A character's own name before those of its joints tells nothing of them") {
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  const std::string prefix = GENERATE("guard_", "bodyguard_", "Coda_", "rabo_", "Queue_", "knight_");
  INFO(prefix);
  for (auto& [key, name] : body.names) {
    name = prefix + name;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.isBiped);
  CHECK(read.planConfidence > 0.8);
  checkArmsAndLegs(built, read);
}

TEST_CASE("A skirt is no mirror of a person who lowers one arm, with names and without") {
  SyntheticBiped body = makeBody({.toes = false, .fingers = false});
  body.tubes = true;
  const int rows = GENERATE(6, 8, 10);
  for (int row = 0; row < rows; ++row) {
    const double angle = 2.0 * pi * (row + 0.5) / rows;
    const std::string stem = "skirt" + std::to_string(row) + "_";
    std::string above = "hips";
    for (int i = 0; i < 3; ++i) {
      const double radius = 0.15 + 0.06 * i;
      const std::string key = stem + std::to_string(i);
      body.joints.push_back(
          {key, above, {radius * std::sin(angle), 0.95 - 0.22 * i, radius * std::cos(angle)}});
      above = key;
    }
  }
  const Vec3 shoulder = jointOf(body, "upperArm.l").position;
  jointOf(body, "foreArm.l").position = shoulder - Vec3(-0.05, 0.28, 0.0);
  jointOf(body, "hand.l").position = shoulder - Vec3(-0.08, 0.53, 0.0);
  if (GENERATE(false, true)) {
    applyNames(body, namingScheme("Unreal"));
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.isBiped);
  checkLegs(built, read);
}

TEST_CASE(
    "A serpent without a mesh keeps its joints, however its row winds and however long its first bone") {
  SyntheticBiped body;
  body.withMesh = false;
  const bool winds = GENERATE(false, true);
  constexpr int joints = 14;
  for (int i = 0; i < joints; ++i) {
    const std::string above = i == 0 ? "" : "segment" + std::to_string(i - 1);
    const double x = winds && i % 4 > 1 ? 0.3 : 0.0;
    const double first = winds || i == 0 ? 0.0 : 0.25;
    body.joints.push_back({"segment" + std::to_string(i), above, {x, 0.05, 0.1 * i + first}});
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "serpent");
  const Limb* const spine = limbAt(read.limbs, biped::spine);
  REQUIRE(spine != nullptr);
  CHECK(spine->joints.size() + (spine->endNode.exists() ? 1 : 0) == joints);
}

TEST_CASE("A fish whose fins are called arms is a serpent still") {
  SyntheticBiped body = makeSnake();
  for (const auto& [side, sign] : sides) {
    body.joints.push_back({"upperArm" + side, "segment8", {sign * 0.1, 0.0, 0.12}});
    body.joints.push_back({"foreArm" + side, "upperArm" + side, {sign * 0.12, 0.02, 0.12}});
  }
  applyNames(body, namingScheme("Unreal"));
  CHECK(detectBody(build(body).scene).plan == "serpent");
}

TEST_CASE("A thigh in line with the joint called hip above it begins the leg") {
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  for (const auto& [side, sign] : sides) {
    SyntheticJoint& thigh = jointOf(body, "thigh" + side);
    const Vec3 down = jointOf(body, "shin" + side).position - thigh.position;
    body.joints.push_back({"hip" + side, thigh.parent, thigh.position - 0.2 * down});
    body.names["hip" + side] = side == ".l" ? "L_Hip" : "R_Hip";
    jointOf(body, "thigh" + side).parent = "hip" + side;
  }
  const BuiltBiped built = build(body);
  checkLegs(built, detectBody(built.scene));
}

TEST_CASE("Clothes with a skeleton of their own in the body's place are no second character") {
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  const double beside = GENERATE(0.0, 1.6);
  addOther(body, makeNamedBody("Mixamo", {.fingers = false}), {beside, 0.0, 0.0});
  body.tubes = true;
  const Body read = detectBody(build(body).scene);
  const bool isTold = std::ranges::any_of(read.warnings, [](const std::string& warning) {
    return warning.find("characters in the file") != std::string::npos;
  });
  CHECK(isTold == (beside > 0.0));
}

namespace {

/// The rump is left out if it has a name of its own.
void checkTailBehindRump(SyntheticBiped& body) {
  const bool isNamed = GENERATE(true, false);
  if (isNamed) {
    body.names["rump"] = "Butt";
  }
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), {LimbKind::tail}) ==
        (isNamed ? "tail0 tail1 -> tail2" : "rump tail0 tail1 -> tail2"));
}

} // namespace

TEST_CASE("A tail begins at the first joint that is called so, or at one without a name before it") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  body.joints.push_back({"rump", "hips", {0.0, 1.4, -0.7}});
  jointOf(body, "tail0").parent = "rump";
  jointOf(body, "tail0").position = {0.0, 1.3, -0.95};
  checkTailBehindRump(body);
}

TEST_CASE("A person's tail begins at the first joint that is called so as well") {
  SyntheticBiped body = makeNamedBody("Unreal");
  const Vec3 hips = jointOf(body, "hips").position;
  body.joints.push_back({"rump", "hips", hips + Vec3(0.0, 0.0, -0.1)});
  std::string above = "rump";
  for (const char* const key : {"tail0", "tail1", "tail2"}) {
    body.joints.push_back({key, above, jointOf(body, above).position + Vec3(0.0, -0.1, -0.2)});
    body.names[key] = key;
    above = key;
  }
  checkTailBehindRump(body);
}

TEST_CASE("A tail of one joint that is called so reaches as far as its mesh") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  std::erase_if(body.joints,
                [](const SyntheticJoint& joint) { return joint.key == "tail1" || joint.key == "tail2"; });
  body.tubes = true;
  jointOf(body, "tail0").flesh = {0.0, -0.3, -0.4};
  const bool isNamed = GENERATE(true, false);
  body.names["tail0"] = isNamed ? "tail" : "bone";
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), {LimbKind::tail}) ==
        (isNamed ? "tail0 -> estimated" : "none"));
}

TEST_CASE("A tail of which but a late joint is called so keeps all of them, a beast's and a person's") {
  const auto addTail = [](SyntheticBiped& body) {
    std::string above = "hips";
    for (int i = 0; i < 5; ++i) {
      const std::string key = "rear" + std::to_string(i);
      body.joints.push_back({key, above, jointOf(body, above).position + Vec3(0.0, -0.05, -0.2)});
      body.names[key] = i == 4 ? "TailFluff" : "b" + std::to_string(i);
      above = key;
    }
  };
  SyntheticBiped horse = makeHorse();
  nameByKeys(horse);
  std::erase_if(horse.joints, [](const SyntheticJoint& joint) { return joint.key.starts_with("tail"); });
  SyntheticBiped person = makeNamedBody("Unreal");
  SyntheticBiped& body = GENERATE(true, false) ? horse : person;
  addTail(body);
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), {LimbKind::tail}) == "rear0 rear1 rear2 rear3 -> rear4");
}

TEST_CASE("What is called a tail and hangs on the head, or is an abdomen, is no tail of one joint") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  body.tubes = true;
  const bool isHair = GENERATE(true, false);
  std::erase_if(body.joints, [](const SyntheticJoint& joint) { return joint.key.starts_with("tail"); });
  const std::string parent = isHair ? "head" : "spine0";
  body.joints.push_back({"lone", parent, jointOf(body, parent).position + Vec3(0.0, -0.2, -0.05)});
  jointOf(body, "lone").flesh = {0.0, -0.3, -0.3};
  body.names["lone"] = isHair ? "Hair_Tail" : "Abdomen";
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), {LimbKind::tail}) == "none");
}

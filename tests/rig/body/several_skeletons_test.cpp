// A file that holds more than one skeleton: a person beside what it sits on, wears or rides.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "rig/body/reading/detection.h"
#include "rig/body/reading/planned_body.h"
#include "rig/plan/body_plan.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

bool tellsOfOthers(const Body& read) {
  return std::ranges::any_of(read.warnings, [](const std::string& warning) {
    return warning.find("characters in the file") != std::string::npos;
  });
}

SyntheticBiped person() {
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  body.tubes = true;
  return body;
}

SyntheticBiped namedHorse() {
  SyntheticBiped horse = makeHorse();
  nameByKeys(horse);
  return horse;
}

// Only the joints whose keys begin so.
SyntheticBiped partOf(SyntheticBiped body, const std::vector<std::string>& stems) {
  std::erase_if(body.joints, [&](const SyntheticJoint& joint) {
    return std::ranges::none_of(stems, [&](const std::string& stem) { return joint.key.starts_with(stem); });
  });
  for (SyntheticJoint& joint : body.joints) {
    const bool hangs = std::ranges::any_of(
        body.joints, [&](const SyntheticJoint& other) { return other.key == joint.parent; });
    joint.parent = hangs ? joint.parent : "";
  }
  return body;
}

// First in the file.
SyntheticBiped before(const SyntheticBiped& first, const SyntheticBiped& second) {
  SyntheticBiped body = second;
  addOther(body, first, Vec3(0.0));
  std::rotate(body.joints.begin(), body.joints.begin() + static_cast<std::ptrdiff_t>(second.joints.size()),
              body.joints.end());
  return body;
}

} // namespace

TEST_CASE("A rider and a horse on skeletons of their own are no insect") {
  SyntheticBiped body = person();
  addOther(body, namedHorse(), {0.0, -0.2, 0.0});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(tellsOfOthers(read));
  const Body horse = bodyAsPlan(built.scene, *planNamed("quadruped"));
  CHECK(
      describe(built, horse, {LimbKind::leg, LimbSide::left, 2}).starts_with("other thigh.l other calf.l "));
  CHECK(describe(built, horse, {LimbKind::leg, LimbSide::left, 1}).starts_with("other scapula.l "));
}

TEST_CASE("The legs of a chair are none of the person's beside it") {
  SyntheticBiped body = person();
  body.joints.push_back({"chair", "", {0.9, 0.5, 0.0}});
  for (const auto& [side, sign] : sides) {
    for (const auto& [row, z] :
         {std::pair(std::string("Front"), 0.3), std::pair(std::string("Back"), -0.3)}) {
      const double x = 0.9 + 0.25 * sign;
      body.joints.push_back({"leg" + row + side, "chair", {x, 0.45, z}});
      body.joints.push_back({"foot" + row + side, "leg" + row + side, {x, 0.05, z}});
    }
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE("Of two horses each limb belongs to one, and the other is told") {
  const Vec3 away = GENERATE(Vec3(0.0, 0.0, 3.0), Vec3(1.4, 0.0, 0.0), Vec3(1.5, 0.0, 1.0));
  SyntheticBiped body = namedHorse();
  addOther(body, namedHorse(), away);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(tellsOfOthers(read));
  const bool isOther = keyOf(built, read.hips).starts_with("other ");
  for (const Limb& limb : read.limbs) {
    CAPTURE(limb.id);
    for (const NodeIndex joint : limb.joints) {
      CHECK(keyOf(built, joint).starts_with("other ") == isOther);
    }
  }
}

TEST_CASE("The joints of clothes with a skeleton of their own are none of the body's") {
  const SyntheticBiped clothes =
      GENERATE(partOf(person(), {"hips", "thigh", "shin", "foot", "toe"}),
               partOf(person(), {"spine", "clavicle", "upperArm", "foreArm", "hand"}),
               partOf(person(),
                      {"hips", "spine", "clavicle", "upperArm", "foreArm", "hand", "thigh", "shin", "foot"}));
  const BuiltBiped built = build(before(clothes, person()));
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK_FALSE(tellsOfOthers(read));
}

TEST_CASE("A person whose trunk is a skeleton beside that of the limbs keeps its spine and its neck") {
  SyntheticBiped body = person();
  body.joints.push_back({"torso", "", jointOf(body, "hips").position});
  body.names["torso"] = "torso";
  for (const auto& [side, sign] : sides) {
    jointOf(body, "clavicle" + side).parent = "torso";
    jointOf(body, "thigh" + side).parent = "torso";
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(describe(built, read, biped::spine) == "spine0 spine1 -> spine2");
  CHECK(describe(built, read, biped::neck) == "neck0 -> head");
}

TEST_CASE("A person whose legs hang from skeletons of their own keeps them") {
  SyntheticBiped body = person();
  const std::string from = GENERATE("thigh", "foot");
  for (const auto& [side, sign] : sides) {
    jointOf(body, from + side).parent = "";
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

#include <catch2/catch.hpp>

#include "rig/body/evidence/own_names.h"
#include "rig/body/reading/detection.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

void nameAll(SyntheticBiped& body, const std::string& before) {
  for (auto& [key, name] : body.names) {
    name = before + name;
  }
}

} // namespace

TEST_CASE("A character's name before the name of each of its joints says nothing about them") {
  const std::string before = GENERATE("EndBoss_", "PumpkinHead_", "Char_R_", "L1_", "Left_Guy_", "Hat_Kid_",
                                      "Wing_", "IK Man ", "Leg_Day_");
  CAPTURE(before);
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  body.tubes = true;
  const BuiltBiped plain = build(body);
  nameAll(body, before);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(describe(built, read, biped::spine) == describe(plain, detectBody(plain.scene), biped::spine));
  CHECK(describe(built, read, biped::neck) == describe(plain, detectBody(plain.scene), biped::neck));
  CHECK(read.warnings.empty());
}

TEST_CASE("A beast keeps its legs where each of its joints is named after it first") {
  const std::string before = GENERATE("Fin_", "Wing_", "Head_Crab_", "Horn_Beast_");
  CAPTURE(before);
  SyntheticBiped horse = makeHorse();
  nameByKeys(horse);
  nameAll(horse, before);
  CHECK(detectBody(build(horse).scene).plan == "quadruped");
}

TEST_CASE("What the joints of limbs alone share is told by their names") {
  SyntheticBiped spider = makeManyLegged(4);
  nameByKeys(spider);
  for (auto& [key, name] : spider.names) {
    name = key.starts_with("leg") ? "Leg_" + name : name;
  }
  const BuiltBiped built = build(spider);
  for (const auto& [key, node] : built.node) {
    CHECK(body::ownNames(built.scene)[at(node)] == built.scene.nodes[at(node)].name);
  }
}

TEST_CASE("A file of a few joints keeps their names") {
  Scene scene;
  scene.nodes.resize(4);
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    scene.nodes[node].name = "Arm_" + std::string(1, static_cast<char>('a' + node));
    scene.nodes[node].parent = NodeIndex(static_cast<int>(node) - 1);
  }
  CHECK(body::ownNames(scene)[2] == "Arm_c");
}

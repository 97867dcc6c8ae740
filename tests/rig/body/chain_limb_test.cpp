#include <algorithm>
#include <limits>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/nodes.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

BuiltBiped unreal() {
  SyntheticBiped body = makeBody();
  addTwist(body, "helper.l", "upperArm.l", "foreArm.l", 1.0, true);
  body.joints.back().isJoint = false;
  applyNames(body, namingScheme("Unreal"));
  return build(body);
}

} // namespace

TEST_CASE("any chain of joints can be a limb, by name or by index") {
  const BuiltBiped built = unreal();
  const Result<Limb> byName = chainLimb(built.scene, "clavicle_l", "hand_l");
  REQUIRE(byName.ok());
  CHECK(byName->id == "clavicle_l..hand_l");
  CHECK(byName->kind == LimbKind::chain);
  CHECK(byName->joints ==
        std::vector{built.node.at("clavicle.l"), built.node.at("upperArm.l"), built.node.at("foreArm.l")});
  CHECK(byName->endNode == built.node.at("hand.l"));
  CHECK(byName->restLength > 0.5);
  const auto indexOf = [&](const std::string& key) { return fmt::format("#{}", built.node.at(key).value); };
  const Result<Limb> byIndex = chainLimb(built.scene, indexOf("clavicle.l"), indexOf("hand.l"));
  REQUIRE(byIndex.ok());
  CHECK(byIndex->joints == byName->joints);
}

TEST_CASE("joints that make no chain are refused, with what is wrong") {
  BuiltBiped built = unreal();
  const auto refusal = [&](const std::string& a, const std::string& b) {
    const Result<Limb> limb = chainLimb(built.scene, a, b);
    REQUIRE_FALSE(limb.ok());
    return limb.error().line();
  };
  CHECK(refusal("nobody", "hand_l").find("no node has this name") != std::string::npos);
  CHECK(refusal("hand_l", "#999").find("no node has this index") != std::string::npos);
  CHECK(refusal("hand_l", "#4x").find("no node has this index") != std::string::npos);
  CHECK(refusal("hand_l", "hand_l").find("two different joints") != std::string::npos);
  CHECK(refusal("hand_l", "upperarm_l").find("name the upper joint first") != std::string::npos);
  CHECK(refusal("hand_l", "foot_r").find("one chain") != std::string::npos);
  built.scene.nodes[at(built.node.at("hand.r"))].name = "hand_l";
  const std::string several = refusal("clavicle_l", "hand_l");
  CHECK_THAT(several, Catch::Contains("several nodes have this name"));
  const int left = built.node.at("hand.l").value;
  const int right = built.node.at("hand.r").value;
  CHECK_THAT(several, Catch::EndsWith(fmt::format("say which one: #{}, #{}", std::min(left, right),
                                                  std::max(left, right))));
}

TEST_CASE("among nodes of one name the joint is meant, not the mesh") {
  BuiltBiped built = unreal();
  built.scene.nodes.back().name = "hand_l";
  CHECK(chainLimb(built.scene, "upperarm_l", "hand_l").ok());
}

TEST_CASE("a chain without a length is refused") {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].children = {NodeIndex(1)};
  scene.nodes[1].parent = NodeIndex(0);
  const double along = GENERATE(0.0, 1e308, std::numeric_limits<double>::quiet_NaN());
  scene.nodes[1].rest.translation = Vec3(along, along, 0.0);
  const Result<Limb> limb = chainLimb(scene, "#0", "#1");
  REQUIRE_FALSE(limb.ok());
  CHECK(limb.error().line().find("no length") != std::string::npos);
}

TEST_CASE("of nodes of one name six are listed, and a name that looks like an index goes before it") {
  Scene scene;
  for (int i = 0; i < 6; ++i) {
    addNode(scene, "arm", NodeIndex::none, Vec3(0.0));
  }
  const auto refusal = [&] {
    const Result<NodeIndex> found = jointByName(scene, "arm");
    REQUIRE_FALSE(found.ok());
    return found.error().line();
  };
  CHECK_THAT(refusal(), Catch::EndsWith("say which one: #0, #1, #2, #3, #4, #5"));
  addNode(scene, "arm", NodeIndex::none, Vec3(0.0));
  CHECK_THAT(refusal(), Catch::EndsWith("say which one: #0, #1, #2, #3, #4, #5, ..."));
  const NodeIndex named = addNode(scene, "#1", NodeIndex::none, Vec3(0.0));
  REQUIRE(jointByName(scene, "#1").ok());
  CHECK(*jointByName(scene, "#1") == named);
  REQUIRE(jointByName(scene, "#2").ok());
  CHECK(*jointByName(scene, "#2") == NodeIndex(2));
  CHECK_FALSE(jointByName(scene, "#8").ok()); // There are eight.
}

#include <algorithm>

#include <catch2/catch.hpp>

#include "rig/reach/limb_topology.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

LimbTopology topologyOf(const MovingBiped& moving, const std::string& limb) {
  return limbTopology(moving.scene, moving.limb(limb), moving.body.limbs, bindPlaces(moving.scene));
}

struct Bone {
  std::string limb;
  std::string from;
  std::string to;
  Vec3 aside;
};

} // namespace

TEST_CASE(
    "a joint rides on a bone that it lies along: from a fiftieth before it to a fiftieth before its end") {
  const Bone bone = GENERATE(values<Bone>({{"left-arm", "upperArm.l", "foreArm.l", {0, 1, 0}},
                                           {"right-arm", "upperArm.r", "foreArm.r", {0, 1, 0}},
                                           {"left-leg", "thigh.l", "shin.l", {1, 0, 0}},
                                           {"right-leg", "thigh.r", "shin.r", {1, 0, 0}}}));
  const auto [share, aside, rides] = GENERATE(table<double, double, bool>({{-0.03, 0.0, false},
                                                                           {-0.01, 0.0, true},
                                                                           {0.5, 0.0, true},
                                                                           {0.97, 0.0, true},
                                                                           {0.99, 0.0, false},
                                                                           {1.05, 0.0, false},
                                                                           {0.5, 0.115, true},
                                                                           {0.5, -0.115, true},
                                                                           {0.5, 0.125, false},
                                                                           {0.5, -0.125, false}}));
  const double size = GENERATE(1.0, 0.01);
  CAPTURE(bone.limb, share, aside, size);
  SyntheticBiped body = namedBody();
  addTwist(body, "twist", bone.from, bone.to, share, false);
  const double length = glm::length(jointOf(body, bone.to).position - jointOf(body, bone.from).position);
  const Vec3 line = glm::normalize(jointOf(body, bone.to).position - jointOf(body, bone.from).position);
  const Vec3 across = glm::normalize(bone.aside - line * glm::dot(bone.aside, line));
  jointOf(body, "twist").position += aside * length * across;
  body.size = size;
  const MovingBiped moving = still(body);
  const LimbTopology topology = topologyOf(moving, bone.limb);
  const NodeIndex twist = moving.node.at("twist");
  REQUIRE(topology.bones.front().joint == moving.node.at(bone.from));
  const std::vector<NodeIndex>& riders = topology.bones.front().twistNodes;
  CHECK((std::ranges::find(riders, twist) != riders.end()) == rides);
}

TEST_CASE("a heel that hangs elsewhere goes with the foot that it is near, as the leg is long") {
  const double size = GENERATE(0.01, 1.0, 4.0);
  const auto [away, goes] = GENERATE(table<double, bool>({{0.05, true}, {0.2, true}, {0.32, false}}));
  CAPTURE(size, away);
  SyntheticBiped body = namedBody({.toes = false});
  jointOf(body, "foot.l").parent = "root";
  jointOf(body, "foot.r").parent = "root";
  const Vec3 ankle = jointOf(body, "foot.l").position;
  body.joints.push_back({"heel.l", "root", ankle + Vec3(0.0, 0.0, -away)});
  body.size = size;
  const MovingBiped moving = still(body);
  const NodeIndex heel = moving.node.at("heel.l");
  const auto goesWith = [&](const std::string& limb) {
    const std::vector<NodeIndex> companions = topologyOf(moving, limb).companions;
    return std::ranges::find(companions, heel) != companions.end();
  };
  CHECK(goesWith("left-leg") == goes);
  CHECK_FALSE(goesWith("right-leg"));
}

TEST_CASE("all that rides on a bone, in a group of its own too, is among the nodes that a trail may change") {
  MovingBiped moving = still(namedBody());
  const NodeIndex arm = moving.node.at("foreArm.l");
  const NodeIndex group = addNode(moving.scene, "group", arm, Vec3(0.05, 0.0, 0.0));
  const NodeIndex inner = addNode(moving.scene, "inner", group, Vec3(0.02, 0.0, 0.0));
  const NodeIndex part = addNode(moving.scene, "part", inner, Vec3(0.03, 0.0, 0.0));
  const NodeIndex empty = addNode(moving.scene, "empty", inner, Vec3(0.03, 0.0, 0.0));
  Primitive primitive;
  primitive.positions = {{-0.05F, -0.02F, 0.0F}, {0.05F, -0.02F, 0.0F}, {0.0F, 0.02F, 0.02F}};
  moving.scene.nodes[at(part)].mesh = static_cast<int>(moving.scene.meshes.size());
  moving.scene.meshes.push_back({"part", {primitive}, {}});
  const Limb& limb = moving.limb("left-arm");
  const LimbTopology topology = topologyOf(moving, "left-arm");
  CHECK(topology.bones[1].twistNodes == std::vector<NodeIndex>{group, inner, part}); // parents first
  CHECK(topology.bones[0].twistNodes.empty());
  const std::vector<NodeIndex> touched = touchedNodes(limb, topology);
  CHECK(std::ranges::is_sorted(touched));
  for (const NodeIndex node : {group, inner, part, arm, moving.node.at("upperArm.l"), limb.endNode}) {
    CHECK(std::ranges::count(touched, node) == 1);
  }
  CHECK(std::ranges::count(touched, empty) == 0);
}

// Controllers and attributes that each kind of limb brings, told one by one.
#include "rig/controllers/controller.h"

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rig/controllers/finger_joints.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

/// Nodes 0 to 19 named "a" to "t" in one chain, of which a skin has all.
Scene chainOfNodes() {
  Scene scene;
  Skin skin;
  NodeIndex above = NodeIndex::none;
  for (char name = 'a'; name < 'u'; ++name) {
    above = test::addNode(scene, std::string(1, name), above, {0.0, 1.0, 0.0});
    skin.joints.push_back(above);
  }
  skin.inverseBind.resize(skin.joints.size(), Mat4(1.0));
  scene.skins.push_back(skin);
  return scene;
}

Limb limbOf(const LimbPlace& place, std::vector<NodeIndex> joints, NodeIndex end, double length) {
  Limb limb;
  static_cast<LimbPlace&>(limb) = place;
  limb.id = limbName(place);
  limb.joints = std::move(joints);
  limb.endNode = end;
  limb.restLength = length;
  return limb;
}

NodeIndex node(std::size_t index) {
  return NodeIndex(index);
}

/// "left-hand on 3 of left-arm moves turns 0.6".
std::vector<std::string> linesOf(const std::vector<Controller>& controllers) {
  std::vector<std::string> lines;
  lines.reserve(controllers.size());
  for (const Controller& one : controllers) {
    lines.push_back(fmt::format("{} on {} of {}{}{} {:g}", one.id,
                                one.node.exists() ? std::to_string(at(one.node)) : "none",
                                one.limb.empty() ? "none" : one.limb, one.moves ? " moves" : "",
                                one.turns ? " turns" : "", one.length));
  }
  return lines;
}

/// "left-arm.stretch of left-arm 0 to 1, 1".
std::vector<std::string> linesOf(const std::vector<Attribute>& attributes) {
  std::vector<std::string> lines;
  lines.reserve(attributes.size());
  for (const Attribute& one : attributes) {
    lines.push_back(
        fmt::format("{} of {} {:g} to {:g}, {:g}", one.id, one.limb, one.minimum, one.maximum, one.standard));
  }
  return lines;
}

using ToldLines = std::vector<std::string>;

} // namespace

TEST_CASE("A body without limbs has controllers for itself and its hips, and one without hips has none") {
  const Scene scene = chainOfNodes();
  CHECK(linesOf(controllersOf(scene, {}, node(2)).controllers) ==
        ToldLines{"body on none of none moves turns 1", "hips on 2 of none moves turns 1"});
  CHECK(controllersOf(scene, {}, NodeIndex::none).controllers.empty());
}

TEST_CASE("Body and hips count in lengths of the first leg, else of the spine, else of the first limb") {
  const Scene scene = chainOfNodes();
  const Limb arm = limbOf(biped::leftArm, {node(3)}, node(4), 0.7);
  const Limb spine = limbOf(biped::spine, {node(5)}, node(6), 0.5);
  const Limb leg = limbOf(biped::rightLeg, {node(7)}, node(8), 0.9);
  const Limb other = limbOf(biped::leftLeg, {node(9)}, node(10), 0.8);
  const auto lengths = [&](const std::vector<Limb>& limbs) {
    const ControllerList list = controllersOf(scene, limbs, node(1));
    CHECK(list.controllers[0].length == list.controllers[1].length);
    return list.controllers[1].length;
  };
  CHECK(lengths({arm, spine, leg, other}) == 0.9);
  CHECK(lengths({arm, spine}) == 0.5);
  CHECK(lengths({arm}) == 0.7);
}

TEST_CASE(
    "A spine has three controllers: where it begins, in its middle and at the chest, which turns alone") {
  const Scene scene = chainOfNodes();
  const Limb spine = limbOf(biped::spine, {node(1), node(2), node(3), node(4), node(5)}, node(6), 0.5);
  const ControllerList list = controllersOf(scene, {spine}, NodeIndex::none);
  CHECK(linesOf(list.controllers) == ToldLines{"spine-low on 1 of spine moves 0.5",
                                               "spine-mid on 3 of spine moves 0.5",
                                               "spine-top on 6 of spine moves turns 0.5"});
  CHECK(linesOf(list.attributes) ==
        ToldLines{"spine.stretch of spine 0 to 1, 1", "spine.volume of spine 0 to 1, 1"});
}

TEST_CASE("Each kind of limb has its end, its elbow or knee where it bends at one, and its attributes") {
  const Scene scene = chainOfNodes();
  const auto listOf = [&](const LimbPlace& place) {
    return controllersOf(scene, {limbOf(place, {node(1), node(2)}, node(3), 0.5)}, NodeIndex::none);
  };
  const ControllerList leg = listOf(biped::leftLeg);
  CHECK(linesOf(leg.controllers) ==
        ToldLines{"left-foot on 3 of left-leg moves turns 0.5", "left-knee on 2 of left-leg moves 0.5"});
  CHECK(linesOf(leg.attributes) ==
        ToldLines{"left-leg.stretch of left-leg 0 to 1, 1", "left-leg.volume of left-leg 0 to 1, 1",
                  "left-leg.follow of left-leg 0 to 1, 0", "left-leg.softness of left-leg 0 to 0.3, 0",
                  "left-foot.roll of left-leg -1 to 1, 0"});
  const ControllerList neck = listOf(biped::neck);
  CHECK(linesOf(neck.controllers) == ToldLines{"head on 3 of neck moves turns 0.5"});
  CHECK(linesOf(neck.attributes) == ToldLines{"neck.stretch of neck 0 to 1, 1",
                                              "neck.volume of neck 0 to 1, 1",
                                              "neck.follow of neck 0 to 1, 1"});
  const ControllerList wing = listOf({LimbKind::wing, LimbSide::right});
  CHECK(linesOf(wing.controllers) == ToldLines{"right-wing-tip on 3 of right-wing moves turns 0.5",
                                               "right-wing-elbow on 2 of right-wing moves 0.5"});
  CHECK(wing.attribute("right-wing.softness") != nullptr);
  for (const LimbKind kind : {LimbKind::tail, LimbKind::fin, LimbKind::feeler}) {
    const ControllerList list = listOf({kind, LimbSide::middle});
    REQUIRE(list.controllers.size() == 1);
    CHECK(list.controllers[0].kind == ControllerKind::tip);
    CHECK(list.controllers[0].id == list.controllers[0].limb + "-tip");
    CHECK(list.attributes.size() == 3);
    CHECK(list.attributes[2].standard == 1.0);
  }
}

TEST_CASE("Only an arm with fingers curls, and only a leg with a foot of its own rolls") {
  Scene scene = chainOfNodes();
  Limb arm = limbOf(biped::rightArm, {node(1), node(2)}, node(19), 0.5);
  const auto attributes = [&] { return linesOf(controllersOf(scene, {arm}, NodeIndex::none).attributes); };
  const ToldLines usual{"right-arm.stretch of right-arm 0 to 1, 1", "right-arm.volume of right-arm 0 to 1, 1",
                        "right-arm.follow of right-arm 0 to 1, 1",
                        "right-arm.softness of right-arm 0 to 0.3, 0"};
  CHECK(attributes() == usual);
  NodeIndex above = node(19);
  for (const char* const name : {"index1", "index2", "index3"}) {
    above = test::addNode(scene, name, above, {0.03, 0.0, 0.0});
    scene.skins[0].joints.push_back(above);
  }
  ToldLines curling = usual;
  curling.emplace_back("right-hand.curl of right-arm -0.2 to 1, 0");
  CHECK(attributes() == curling);
  Limb leg = limbOf(biped::leftLeg, {node(1), node(2)}, NodeIndex::none, 0.5);
  leg.endOffset = Vec3(0.0, 1.0, 0.0);
  const ControllerList list = controllersOf(scene, {leg}, NodeIndex::none);
  CHECK(list.attribute("left-foot.roll") == nullptr);
  CHECK(linesOf(list.controllers) ==
        ToldLines{"left-foot on none of left-leg moves 0.5", "left-knee on 2 of left-leg moves 0.5"});
}

TEST_CASE("A leg of one bone has no knee, and limbs without joints and marked chains have no controller") {
  const Scene scene = chainOfNodes();
  const auto count = [&](const Limb& limb) {
    return controllersOf(scene, {limb}, NodeIndex::none).controllers.size();
  };
  CHECK(count(limbOf(biped::leftLeg, {node(1)}, node(2), 0.5)) == 1);
  CHECK(count(limbOf(biped::leftLeg, {}, node(2), 0.5)) == 0);
  Limb rope = limbOf({LimbKind::chain, LimbSide::middle}, {node(1), node(2)}, node(3), 0.5);
  rope.id = "b..d";
  CHECK(count(rope) == 0);
  CHECK(controllersOf(scene, {rope}, NodeIndex::none).attributes.empty());
}

TEST_CASE("Ends come before elbows and knees, after the trunk's, in the order of the limbs") {
  const Scene scene = chainOfNodes();
  const std::vector<Limb> limbs{limbOf(biped::rightArm, {node(1), node(2)}, node(3), 0.5),
                                limbOf(biped::leftLeg, {node(4), node(5)}, node(6), 0.5),
                                limbOf(biped::spine, {node(7)}, node(8), 0.5),
                                limbOf(biped::neck, {node(9)}, node(10), 0.5)};
  ToldLines ids;
  for (const Controller& one : controllersOf(scene, limbs, node(0)).controllers) {
    ids.push_back(one.id);
  }
  CHECK(ids == ToldLines{"body", "hips", "spine-low", "spine-mid", "spine-top", "head", "right-hand",
                         "left-foot", "right-elbow", "left-knee"});
}

TEST_CASE("Names of ends and elbows keep what else a limb's name says") {
  const auto named = [](const LimbPlace& place, const std::string& id) {
    Limb limb = limbOf(place, {node(1)}, node(2), 1.0);
    limb.id = id;
    return endController(limb) + " " + poleController(limb);
  };
  CHECK(named({LimbKind::leg, LimbSide::left, 1}, "front-left-leg") == "front-left-foot front-left-knee");
  CHECK(named({LimbKind::leg, LimbSide::left, 2}, "left-leg-2") == "left-foot-2 left-knee-2");
  CHECK(named({LimbKind::arm, LimbSide::right}, "right-arm-3") == "right-hand-3 right-elbow-3");
  CHECK(named({LimbKind::arm, LimbSide::right}, "limb") == "limb-hand limb-elbow");
  CHECK(named({LimbKind::leg, LimbSide::right}, "limb") == "limb-foot limb-knee");
  CHECK(named(biped::spine, "spine") == " ");
}

TEST_CASE("A joint that no limb has is a controller by its name or number, and others say what moves them") {
  const Scene scene = chainOfNodes();
  const std::vector<Limb> limbs{limbOf(biped::leftArm, {node(3), node(4)}, node(5), 0.7)};
  const ControllerList list = controllersOf(scene, limbs, node(2));
  const auto named = [&](const std::string& id) { return controllerNamed(scene, limbs, node(2), list, id); };
  CHECK(named("left-hand")->kind == ControllerKind::hand);
  const Result<Controller> free = named("h");
  REQUIRE(free);
  CHECK(linesOf(std::vector<Controller>{*free}) == ToldLines{"h on 7 of none turns 0.7"});
  CHECK(free->kind == ControllerKind::joint);
  CHECK(named("#8")->node == node(8));
  for (const char* const taken : {"c", "d", "e", "f", "#5"}) {
    CAPTURE(taken);
    const Result<Controller> refused = named(taken);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().what, Catch::Contains("belongs to a limb or to the hips"));
    CHECK_THAT(refused.error().remedy, Catch::Contains("body, hips, left-hand, left-elbow"));
  }
  const Result<Controller> unknown = named("zebra");
  REQUIRE_FALSE(unknown);
  CHECK_THAT(unknown.error().what, Catch::Contains("no controller 'zebra'"));
  CHECK_THAT(unknown.error().remedy, Catch::Contains("body, hips, left-hand, left-elbow"));
  CHECK_THAT(controllerNamed(scene, {}, NodeIndex::none, {}, "zebra").error().remedy,
             Catch::Contains("none"));
}

TEST_CASE("Joints of a skin below the hips that no limb has are controllers, marked chains' among them") {
  Scene scene = chainOfNodes();
  scene.skins[0].joints.resize(9); // "a" to "i".
  std::vector<Limb> limbs{limbOf(biped::leftArm, {node(3), node(4)}, node(5), 0.7)};
  const auto ids = [&](NodeIndex hips) {
    ToldLines names;
    for (const Controller& one : jointControllers(scene, limbs, hips)) {
      CHECK(one.length == 0.7);
      CHECK_FALSE(one.moves);
      names.push_back(one.id);
    }
    return names;
  };
  CHECK(ids(node(2)) == ToldLines{"g", "h", "i"});
  CHECK(ids(node(1)) == ToldLines{"c", "g", "h", "i"});
  CHECK(ids(NodeIndex::none).empty());
  limbs.push_back(limbOf({LimbKind::chain, LimbSide::middle}, {node(6), node(7)}, node(8), 0.2));
  CHECK(ids(node(2)) == ToldLines{"g", "h", "i"});
  scene.nodes[7].name = "g"; // Two of one name.
  CHECK(ids(node(2)) == ToldLines{"#6", "#7", "i"});
}

TEST_CASE("Fingers are the chains below the hand that do not branch, those below a joint of the palm too") {
  Scene scene = chainOfNodes(); // upper arm, lower arm, hand are "a", "b", "c"
  scene.nodes[2].children.clear();
  const auto below = [&](NodeIndex parent) {
    const NodeIndex made = test::addNode(scene, "joint", parent, {0.0, 0.1, 0.0});
    scene.skins[0].joints.push_back(made);
    scene.skins[0].inverseBind.emplace_back(1.0);
    return made;
  };
  const NodeIndex thumb = below(node(2));
  const NodeIndex palm = below(node(2));
  const NodeIndex thumbTip = below(thumb);
  const NodeIndex innerPalm = below(palm);
  const NodeIndex index = below(palm);
  const NodeIndex ring = below(innerPalm);
  const NodeIndex little = below(innerPalm);
  const NodeIndex indexTip = below(index);
  const Limb arm = limbOf({LimbKind::arm, LimbSide::left}, {node(0), node(1)}, node(2), 2.0);
  using Chains = std::vector<std::vector<NodeIndex>>;
  CHECK(fingerChains(scene, arm) == Chains{{thumb, thumbTip}, {ring}, {little}, {index, indexTip}});
  CHECK(fingerJoints(scene, arm) == std::vector<NodeIndex>{thumb, thumbTip, ring, little, index, indexTip});
}

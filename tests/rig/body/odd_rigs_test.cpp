#include <algorithm>
#include <array>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

SyntheticJoint& joint(SyntheticBiped& body, const std::string& key) {
  return *std::ranges::find(body.joints, key, &SyntheticJoint::key);
}

} // namespace

TEST_CASE("twist joints beside and inside a limb's bones are not joints of the limb") {
  for (const std::string scheme : {"Unreal", "no names"}) {
    DYNAMIC_SECTION(scheme) {
      SyntheticBiped body = makeBody();
      for (const std::string side : {".l", ".r"}) {
        addTwist(body, "armTwist" + side, "upperArm" + side, "foreArm" + side, 0.5, false);
        addTwist(body, "foreTwist" + side, "foreArm" + side, "hand" + side, 0.5, true);
        addTwist(body, "legTwist" + side, "thigh" + side, "shin" + side, 0.5, true);
      }
      applyNames(body, namingScheme(scheme));
      if (scheme == "Unreal") {
        body.names["armTwist.l"] = "upperarm_twist_01_l";
        body.names["foreTwist.l"] = "lowerarm_twist_01_l";
      }
      const BuiltBiped built = build(body);
      checkArmsAndLegs(built, detectBody(built.scene));
    }
  }
}

TEST_CASE("limbs split in two keep the first half as their joint, disconnected deform bones included") {
  SyntheticBiped body = makeNamedBody("Rigify deform bones");
  for (const std::string side : {".l", ".r"}) {
    const std::string mark = side == ".l" ? ".L" : ".R";
    for (const auto& [key, child, name] :
         {std::tuple("upperArm", "foreArm", "DEF-upper_arm"), std::tuple("foreArm", "hand", "DEF-forearm"),
          std::tuple("thigh", "shin", "DEF-thigh"), std::tuple("shin", "foot", "DEF-shin")}) {
      const std::string half = std::string(key) + "Half" + side;
      addTwist(body, half, key + side, child + side, 0.5, true);
      body.names[half] = std::string(name) + mark + ".001";
    }
  }
  SECTION("one tree") {
    const BuiltBiped built = build(body);
    checkArmsAndLegs(built, detectBody(built.scene));
  }
  SECTION("limbs and trunk are separate trees") {
    for (const std::string side : {".l", ".r"}) {
      joint(body, "thigh" + side).parent = "";
      joint(body, "clavicle" + side).parent = "";
      joint(body, "upperArm" + side).parent = "";
    }
    joint(body, "hips").parent = "";
    const BuiltBiped built = build(body);
    const Body biped = detectBody(built.scene);
    checkArmsAndLegs(built, biped);
    CHECK(describe(built, biped, biped::spine) == "spine0 spine1 -> spine2");
    CHECK(describe(built, biped, biped::neck) == "neck0 -> head");
  }
}

TEST_CASE("clavicles under the neck and thighs under the spine leave spine and neck where names put them") {
  SyntheticBiped body = makeNamedBody("3ds Max Biped");
  for (const std::string side : {".l", ".r"}) {
    joint(body, "clavicle" + side).parent = "neck0";
    joint(body, "thigh" + side).parent = "spine0";
  }
  joint(body, "spine0").position = Vec3(0, 1.0, 0.0);
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(describe(built, biped, biped::spine) == "spine0 spine1 -> spine2");
  CHECK(describe(built, biped, biped::neck) == "neck0 -> head");
  CHECK(biped.hips == built.node.at("hips"));
}

TEST_CASE("legs that hang from a pelvis beside the spine belong to the joint that carries both") {
  SyntheticBiped body = makeNamedBody("Character Creator");
  body.joints.push_back({"pelvis", "hips", Vec3(0, 0.97, 0)});
  body.names["pelvis"] = "CC_Base_Pelvis";
  joint(body, "thigh.l").parent = "pelvis";
  joint(body, "thigh.r").parent = "pelvis";
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(biped.hips == built.node.at("hips"));
  CHECK(describe(built, biped, biped::spine) == "spine0 spine1 -> spine2");
}

TEST_CASE("limbs of two joints end where their mesh does") {
  SyntheticBiped body = makeBody({.clavicles = false, .hands = false, .feet = false});
  const bool hasNames = GENERATE(true, false);
  if (hasNames) {
    applyNames(body, namingScheme("glued lower case"));
  }
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(biped.isBiped);
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.l foreArm.l -> estimated");
  CHECK(describe(built, biped, biped::rightLeg) == "thigh.r shin.r -> estimated");
  const Vec3 wrist = endOf(built.scene, *findLimb(biped, biped::leftArm));
  CHECK(wrist.x == Approx(0.72).margin(0.01));
  const Vec3 ankle = endOf(built.scene, *findLimb(biped, biped::rightLeg));
  CHECK(ankle.x == Approx(-0.1).margin(0.01));
  CHECK(ankle.y == Approx(0.03).margin(0.01));
}

TEST_CASE("palms without a hand make the end of the arm their mean") {
  SyntheticBiped body = makeNamedBody("glued lower case", {.hands = false});
  for (const std::string side : {".l", ".r"}) {
    const double sign = side == ".l" ? 1.0 : -1.0;
    for (int palm = 0; palm < 2; ++palm) {
      const std::string key = "palm" + std::to_string(palm) + side;
      body.joints.push_back({key, "foreArm" + side, Vec3(sign * 0.7, 1.43, 0.04 * palm)});
      body.names[key] = "Palm" + std::to_string(palm) + (side == ".l" ? ".L" : ".R");
    }
  }
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.l foreArm.l -> estimated");
  CHECK(glm::distance(endOf(built.scene, *findLimb(biped, biped::rightArm)), Vec3(-0.7, 1.43, 0.02)) < 1e-9);
}

TEST_CASE("a foot under the root is the leg's end all the same") {
  SyntheticBiped body = makeBody();
  joint(body, "foot.l").parent = "root";
  joint(body, "foot.r").parent = "root";
  const bool hasNames = GENERATE(true, false);
  if (hasNames) {
    applyNames(body, namingScheme("glued lower case"));
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE("handles of the animator's in the skin are never limb joints") {
  SyntheticBiped body = makeNamedBody("Unreal");
  for (const std::string side : {".l", ".r"}) {
    const double sign = side == ".l" ? 1.0 : -1.0;
    for (const auto& [key, position] :
         {std::pair("kneeIK", Vec3(0.1, 0.5, 0.5)), std::pair("IK-foot", Vec3(0.1, 0.09, -0.03)),
          std::pair("handIK", Vec3(0.7, 1.43, -0.02)), std::pair("PoleTarget", Vec3(0.4, 1.4, -0.5))}) {
      body.joints.push_back(
          {key + side, "root", Vec3(sign * position.x, position.y, position.z), true, false});
      body.names[key + side] = key + side;
    }
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE("helper nodes between joints are not listed") {
  SyntheticBiped body = makeNamedBody("French");
  for (const std::string side : {".l", ".r"}) {
    addTwist(body, "foreArmHelper" + side, "upperArm" + side, "foreArm" + side, 1.0, true);
    body.joints.back().isJoint = false;
    addTwist(body, "shinHelper" + side, "thigh" + side, "shin" + side, 1.0, true);
    body.joints.back().isJoint = false;
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE(
    "names that call the right side left give way to feet that clearly point the other way, with a warning") {
  SyntheticBiped body = makeBody();
  NamingScheme swapped = namingScheme("Mixamo");
  std::swap(swapped.left, swapped.right);
  applyNames(body, swapped);
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(warnsOf(biped, "sides follow the way its feet point"));
}

TEST_CASE("names that agree win over feet whose mesh points back, the sides are asked for and doubted") {
  SyntheticBiped body = makeNamedBody("Mixamo", {.toes = GENERATE(true, false)});
  body.feetPointBack = true;
  body.facesBackwards = GENERATE(true, false);
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(warnsOf(biped, "are the sides right?"));
  const Body sure = detectBody(build(makeNamedBody("Mixamo")).scene);
  CHECK(findLimb(biped, biped::leftArm)->confidence < 0.85 * findLimb(sure, biped::leftArm)->confidence);
}

TEST_CASE("two arms both named left are told apart by where they are, with a warning") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  body.names["upperArm.r"] = "mixamorig:LeftArm";
  body.names["foreArm.r"] = "mixamorig:LeftForeArm";
  body.names["hand.r"] = "mixamorig:LeftHand";
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(warnsOf(biped, "disagree about left and right"));
}

TEST_CASE("names that call every limb left tell no side: the geometry does, and that is told") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  body.names["upperArm.r"] = body.names["upperArm.l"];
  body.names["foreArm.r"] = body.names["foreArm.l"];
  body.names["hand.r"] = body.names["hand.l"];
  CHECK(warnsOf(detectBody(build(body).scene), "the sides follow most of them"));
  for (const std::string key : {"clavicle", "thigh", "shin", "foot", "toe"}) {
    body.names[key + ".r"] = body.names[key + ".l"];
  }
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(warnsOf(biped, "the sides follow the geometry"));
}

TEST_CASE("a well-named biped is found without a warning and with more confidence than one without names") {
  const BuiltBiped withNames = build(makeNamedBody("Unreal"));
  const BuiltBiped without = build(makeBody());
  const Body sure = detectBody(withNames.scene);
  const Body guessed = detectBody(without.scene);
  CHECK(sure.warnings.empty());
  REQUIRE(sure.limbs.size() == 6);
  REQUIRE(guessed.limbs.size() == 6);
  for (std::size_t i = 0; i < sure.limbs.size(); ++i) {
    CHECK(sure.limbs[i].confidence > 0.9);
    CHECK(sure.limbs[i].confidence > guessed.limbs[i].confidence);
    CHECK(guessed.limbs[i].confidence > 0.35);
    CHECK_FALSE(sure.limbs[i].reasons.empty());
  }
}

TEST_CASE("a character with one arm has that arm only") {
  SyntheticBiped body = makeNamedBody("Unreal");
  std::erase_if(body.joints, [](const SyntheticJoint& each) {
    const bool right = each.key.ends_with(".r");
    return right && (each.key.starts_with("clavicle") || each.key.starts_with("upperArm") ||
                     each.key.starts_with("foreArm") || each.key.starts_with("hand") ||
                     each.key.starts_with("finger"));
  });
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(describe(built, biped, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, biped, biped::rightArm) == "none");
  CHECK(describe(built, biped, biped::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(warnsOf(biped, "no right-arm found"));
  CHECK_FALSE(warnsOf(biped, "neck"));
}

TEST_CASE("A neck that is not found is told where the arms are missing") {
  SyntheticBiped body = makeNamedBody("Unreal", {.neckJoints = 0});
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "no neck found"));
  std::erase_if(body.joints, [](const SyntheticJoint& each) {
    return std::ranges::any_of(std::array{"clavicle", "upperArm", "foreArm", "hand", "finger"},
                               [&](const char* part) { return each.key.starts_with(part); });
  });
  const Body read = detectBody(build(body).scene);
  CHECK(warnsOf(read, "no left-arm, right-arm found"));
  CHECK(warnsOf(read, "no neck found"));
}

TEST_CASE("without a neck the head sits on the chest and there is no neck limb") {
  const BuiltBiped built = build(makeNamedBody("Unreal", {.neckJoints = 0}));
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(describe(built, biped, biped::neck) == "none");
  CHECK(biped.head == built.node.at("head"));
}

TEST_CASE("a neck without a head ends where its mesh does, and that is told of it alone") {
  const auto tellsMissingHead = [](const SyntheticBiped& body) {
    const Body read = detectBody(build(body).scene);
    const Limb* const neck = findLimb(read, biped::neck);
    REQUIRE(neck != nullptr);
    return std::ranges::count(neck->reasons, "no head joint: estimated from the vertices of the last bone") ==
           1;
  };
  SyntheticBiped body = makeNamedBody("Unreal");
  body.tubes = true;
  CHECK_FALSE(tellsMissingHead(body));
  std::erase_if(body.joints, [](const SyntheticJoint& each) { return each.key == "head"; });
  jointOf(body, "neck0").flesh = Vec3(0.0, 0.25, 0.0);
  CHECK(tellsMissingHead(body));
}

TEST_CASE(
    "a spine of one joint ends at the base of the neck, a body without one starts its spine at the hips") {
  const BuiltBiped one = build(makeNamedBody("Unreal", {.spineJoints = 1}));
  CHECK(describe(one, detectBody(one.scene), biped::spine) == "spine0 -> neck0");
  const BuiltBiped none = build(makeNamedBody("Unreal", {.spineJoints = 0}));
  CHECK(describe(none, detectBody(none.scene), biped::spine) == "hips -> neck0");
}

TEST_CASE("a scene without a character gives an empty list and a warning") {
  Scene scene;
  SECTION("nothing at all") {}
  SECTION("one node") {
    scene.nodes.resize(1);
  }
  SECTION("a chain of joints, deeper than any body") {
    scene.nodes.resize(4000);
    Skin skin;
    for (int i = 0; i < 4000; ++i) {
      Node& node = scene.nodes[static_cast<std::size_t>(i)];
      node.parent = NodeIndex(i - 1);
      node.rest.translation = Vec3(0, 0, 0.1);
      if (i + 1 < 4000) {
        node.children.emplace_back(i + 1);
      }
      skin.joints.emplace_back(i);
      skin.inverseBind.push_back(glm::translate(Mat4(1.0), Vec3(0, 0, -0.1 * (i + 1))));
    }
    scene.skins.push_back(skin);
  }
  const Body biped = detectBody(scene);
  CHECK_FALSE(biped.isBiped);
  CHECK(biped.limbs.empty());
  CHECK_FALSE(biped.warnings.empty());
  CHECK(biped.height > 0.0);
}

TEST_CASE("joints that are called after a bone and lie on it are parts of the bone, and no limb starts or "
          "ends at one") {
  SyntheticBiped body = makeBody();
  applyNames(body, {"parts",
                    "L",
                    "R",
                    {{"hips", "Root_M"},
                     {"spine0", "Spine1_M"},
                     {"spine1", "Spine2_M"},
                     {"spine2", "Chest_M"},
                     {"neck0", "Neck_M"},
                     {"head", "Head_M"},
                     {"clavicle", "Scapula_%"},
                     {"upperArm", "Shoulder_%"},
                     {"foreArm", "Elbow_%"},
                     {"hand", "Wrist_%"},
                     {"thigh", "Hip_%"},
                     {"shin", "Knee_%"},
                     {"foot", "Ankle_%"},
                     {"toes", "Toes_%"}}});
  const bool movesShin = GENERATE(true, false); // where it does not, its part carries the bone's mesh
  for (const std::string side : {".l", ".r"}) {
    const std::string mark = side == ".l" ? "_L" : "_R";
    addTwist(body, "part1" + side, "thigh" + side, "shin" + side, 0.33, true);
    addTwist(body, "part2" + side, "part1" + side, "shin" + side, 0.5, true);
    addTwist(body, "assist" + side, "shin" + side, "foot" + side, 0.8, false);
    body.names["part1" + side] = "HipPart1" + mark;
    body.names["part2" + side] = "HipPart2" + mark;
    body.names["assist" + side] = "Ankle_Assist" + mark;
    jointOf(body, "shin" + side).movesMesh = movesShin;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg).starts_with("thigh.l "));
  CHECK(describe(built, read, biped::leftLeg).ends_with("-> foot.l"));
  CHECK(describe(built, read, biped::rightLeg).starts_with("thigh.r "));
  CHECK(describe(built, read, biped::rightLeg).ends_with("-> foot.r"));
}

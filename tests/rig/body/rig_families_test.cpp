#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/extremities.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Families of rigs as exporters and game packs have them, each over several schemes of names and without any.

const std::vector<std::string> schemes{"Mixamo", "Unreal", "Rigify deform bones", "3ds Max Biped",
                                       "no names"};

void eachScheme(const std::function<void(SyntheticBiped&)>& change,
                const std::function<void(const BuiltBiped&, const Body&)>& check) {
  for (const std::string& scheme : schemes) {
    for (const double size : {0.01, 1.0, 100.0}) {
      SyntheticBiped body = makeBody();
      applyNames(body, namingScheme(scheme));
      body.size = size;
      change(body);
      const BuiltBiped built = build(body);
      INFO(scheme << ", size " << size);
      check(built, detectBody(built.scene));
    }
  }
}

bool asksForSides(const Body& body) {
  return std::ranges::any_of(body.warnings, [](const std::string& warning) {
    return warning.find("are the sides right") != std::string::npos;
  });
}

} // namespace

TEST_CASE("Feet that hang from the root end the legs, and no side is doubted") {
  eachScheme(
      [](SyntheticBiped& body) {
        for (const char* foot : {"foot.l", "foot.r"}) {
          jointOf(body, foot).parent = "root";
        }
      },
      [](const BuiltBiped& built, const Body& body) {
        checkArmsAndLegs(built, body);
        CHECK_FALSE(asksForSides(body));
      });
}

TEST_CASE("The centre of a body carries its legs where the joint called hips carries the torso alone") {
  eachScheme(
      [](SyntheticBiped& body) {
        // root > carrier > hips > torso, and the legs beside the hips on the carrier.
        SyntheticJoint carrier{"carrier", "root", Vec3(0.0, 0.95, 0.0)};
        const auto hips = std::ranges::find(body.joints, std::string("hips"), &SyntheticJoint::key);
        body.joints.insert(hips, carrier);
        body.names["carrier"] = body.names.contains("hips") ? "Body" : "";
        jointOf(body, "hips").parent = "carrier";
        for (const char* thigh : {"thigh.l", "thigh.r"}) {
          jointOf(body, thigh).parent = "carrier";
        }
        for (const char* foot : {"foot.l", "foot.r"}) {
          jointOf(body, foot).parent = "root";
        }
      },
      [](const BuiltBiped& built, const Body& body) {
        checkArmsAndLegs(built, body);
        REQUIRE(body.hips.exists());
        for (const char* key : {"thigh.l", "thigh.r", "spine0", "head"}) {
          INFO(key);
          CHECK(isAncestorOrSelf(built.scene, body.hips, built.node.at(key)));
        }
      });
}

TEST_CASE("A skin that was bound in other units than the scene has the height and the lengths of the scene") {
  for (const double units : {0.01, 108.0, 1.0, 1.4}) {
    SyntheticBiped body = makeNamedBody("Mixamo");
    BuiltBiped built = build(body);
    const Body plain = detectBody(built.scene);
    // The mesh and the binds are scaled about the origin: what is shown stays the same.
    for (Skin& skin : built.scene.skins) {
      for (Mat4& bind : skin.inverseBind) {
        bind = bind * glm::scale(Mat4(1.0), Vec3(1.0 / units));
      }
    }
    for (Mesh& mesh : built.scene.meshes) {
      for (Primitive& primitive : mesh.primitives) {
        for (glm::vec3& position : primitive.positions) {
          position *= static_cast<float>(units);
        }
      }
    }
    // An exporter's root joint whose own matrix is in the scene's units hides what the others are in.
    const auto root = std::ranges::find(built.scene.skins[0].joints, built.node.at("root"));
    if (root != built.scene.skins[0].joints.end()) {
      built.scene.skins[0].inverseBind[static_cast<std::size_t>(root - built.scene.skins[0].joints.begin())] =
          Mat4(1.0);
    }
    const Body body2 = detectBody(built.scene);
    INFO("units " << units);
    checkArmsAndLegs(built, body2);
    CHECK(body2.height == Approx(plain.height).epsilon(units > 0.5 && units < 2.0 ? 0.5 : 1e-3));
  }
}

TEST_CASE("A joint that shows the mesh of its skin is the same joint of its limb") {
  const BuiltBiped whole = build(makeNamedBody("Mixamo"));
  const Body plain = detectBody(whole.scene);
  Scene scene = whole.scene;
  const Limb& arm = *limbAt(plain.limbs, {LimbKind::arm, LimbSide::left});
  const NodeIndex elbow = arm.joints.at(1);
  const auto shown = std::ranges::find_if(scene.nodes, [](const Node& node) { return node.skin >= 0; });
  REQUIRE(shown != scene.nodes.end());
  std::swap(scene.nodes[at(elbow)].mesh, shown->mesh);
  std::swap(scene.nodes[at(elbow)].skin, shown->skin);
  const Body body = detectBody(scene);
  CHECK(limbAt(body.limbs, {LimbKind::arm, LimbSide::left})->joints == arm.joints);
  checkArmsAndLegs(whole, body);
}

TEST_CASE("Where only the hands are skinned, the rigid rest counts into the height") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  BuiltBiped whole = build(body);
  const double height = detectBody(whole.scene).height;
  // The skinned mesh keeps the vertices of the hands; a rigid one on the hips holds the whole body.
  Scene scene = whole.scene;
  const NodeIndex hips = whole.node.at("hips");
  Mesh rigid = scene.meshes[0];
  const Mat4 toHips = glm::inverse(bindPoseWorlds(scene)[at(hips)]);
  for (Primitive& primitive : rigid.primitives) {
    primitive.influences.clear();
    for (glm::vec3& position : primitive.positions) {
      position = glm::vec3(Vec3(toHips * Vec4(Vec3(position), 1.0)));
    }
  }
  for (Primitive& primitive : scene.meshes[0].primitives) {
    for (glm::vec3& position : primitive.positions) {
      position.y = std::clamp(position.y, 1.4F, 1.5F);
    }
  }
  scene.meshes.push_back(rigid);
  Node part;
  part.name = "body part";
  part.mesh = static_cast<int>(scene.meshes.size()) - 1;
  part.parent = hips;
  scene.nodes[at(hips)].children.emplace_back(scene.nodes.size());
  scene.nodes.push_back(part);
  CHECK(detectBody(scene).height == Approx(height).epsilon(0.02));
}

TEST_CASE("Hems of a robe are no legs, and what wears it is a biped with its legs") {
  eachScheme(
      [](SyntheticBiped& body) {
        for (const auto& [key, place] :
             {std::pair("hemFront", Vec3(0.0, 0.9, 0.25)), std::pair("hemBack", Vec3(0.0, 0.9, -0.25)),
              std::pair("hemLeft", Vec3(0.28, 0.9, 0.0)), std::pair("hemRight", Vec3(-0.28, 0.9, 0.0))}) {
          const std::string upper = key;
          body.joints.push_back({upper, "hips", place});
          body.joints.push_back({upper + "Low", upper, {place.x * 1.2, 0.4, place.z * 1.2}});
          body.names[upper] = "dress01." + upper;
          body.names[upper + "Low"] = "dress02." + upper;
        }
      },
      [](const BuiltBiped& built, const Body& body) { checkArmsAndLegs(built, body); });
}

TEST_CASE(
    "A two-legged body with a long tail and short front legs is none of a biped's or a quadruped's kind") {
  // An animal with its feet on the root: what game packs call a tyrannosaur.
  SyntheticBiped body;
  const auto add = [&](const std::string& key, const std::string& parent, const Vec3& place) {
    body.joints.push_back({key, parent, place});
    body.names[key] = key;
  };
  body.joints.push_back({"root", "", Vec3(0.0), true, false});
  add("Body", "root", {0, 1.0, 0.1});
  for (const auto& [side, x] : {std::pair(std::string(".L"), 1.0), std::pair(std::string(".R"), -1.0)}) {
    add("BackLeg" + side, "Body", {0.07 * x, 0.9, 0.0});
    add("BackUpLeg" + side, "BackLeg" + side, {0.3 * x, 0.9, 0.0});
    add("BackLowLeg" + side, "BackUpLeg" + side, {0.29 * x, 0.38, -0.2});
    add("BackFoot" + side, "root", {0.29 * x, 0.03, -0.1});
    add("FrontUpLeg" + side, "Body", {0.2 * x, 1.0, 0.45});
    add("FrontLowLeg" + side, "FrontUpLeg" + side, {0.21 * x, 0.82, 0.5});
    add("FrontFoot" + side, "FrontLowLeg" + side, {0.18 * x, 0.72, 0.58});
  }
  std::string before = "Body";
  for (int i = 1; i <= 5; ++i) {
    add("Tail" + std::to_string(i), before, {0.0, 0.95 - 0.06 * i, -0.35 * i});
    before = "Tail" + std::to_string(i);
  }
  add("Torso", "Body", {0, 1.02, 0.35});
  add("Neck", "Torso", {0, 1.25, 0.8});
  add("Head", "Neck", {0, 1.3, 1.0});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "bird");
  CHECK(describe(built, read, biped::leftLeg) == "BackUpLeg.L BackLowLeg.L -> BackFoot.L");
  CHECK(describe(built, read, biped::rightLeg) == "BackUpLeg.R BackLowLeg.R -> BackFoot.R");
  CHECK(describe(built, read, {LimbKind::tail}).starts_with("Tail1 Tail2 Tail3"));
}

TEST_CASE("Front legs of an upright body are its arms, and their collar bones are not") {
  SyntheticBiped body = makeBody();
  applyNames(body, namingScheme("no names"));
  for (const auto& [key, name] :
       {std::pair("clavicle", "Front_Leg_Shoulder_"), std::pair("upperArm", "Front_Leg_Upper_"),
        std::pair("foreArm", "Front_Leg_Lower_"), std::pair("hand", "Hand_"),
        std::pair("thigh", "Back_Leg_Upper_"), std::pair("shin", "Back_Leg_Lower_"),
        std::pair("foot", "Back_Leg_Ankle_")}) {
    body.names[std::string(key) + ".l"] = std::string(name) + "L";
    body.names[std::string(key) + ".r"] = std::string(name) + "R";
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(findLimb(read, biped::leftArm)->confidence > 0.8);
}

TEST_CASE("The legs of a beast are counted from those that are called front ones, however they are spelt") {
  const auto spell = GENERATE(
      as<std::function<std::string(std::string)>>{}, [](std::string name) { return name; },
      [](std::string name) {
        std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
        return name;
      },
      [](std::string name) {
        std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
        return name;
      });
  SyntheticBiped body = makeManyLegged(4);
  nameByKeys(body);
  const BuiltBiped plain = build(body);
  const Body before = detectBody(plain.scene);
  const Limb* const first = findLimb(before, {LimbKind::leg, LimbSide::left, 1});
  REQUIRE(first != nullptr);
  // The same body, whose names say that its other end is in front.
  Scene scene = plain.scene;
  const auto rename = [&](const LimbPlace& place, const std::string& word) {
    const Limb* const limb = findLimb(before, place);
    REQUIRE(limb != nullptr);
    for (const NodeIndex joint : limb->joints) {
      scene.nodes[at(joint)].name =
          spell(word + "Leg" + std::to_string(joint.value) + (place.side == LimbSide::left ? ".R" : ".L"));
    }
  };
  for (const LimbSide side : {LimbSide::left, LimbSide::right}) {
    rename({LimbKind::leg, side, 1}, "Back");
    rename({LimbKind::leg, side, 2}, "MidBack");
    rename({LimbKind::leg, side, 3}, "MidFront");
    rename({LimbKind::leg, side, 4}, "Front");
  }
  for (Node& node : scene.nodes) {
    node.name = node.name.find(spell("Leg")) == std::string::npos ? "" : node.name;
  }
  const Body after = detectBody(scene);
  CHECK(after.plan == before.plan);
  const Limb* const front = findLimb(after, {LimbKind::leg, LimbSide::left, 1});
  REQUIRE(front != nullptr);
  CHECK(scene.nodes[at(front->joints.front())].name.starts_with(spell("Front")));
}

TEST_CASE("A part is read from a name with gaps, without gaps and in capitals") {
  using body::PartWord;
  using Words = std::set<PartWord>;
  for (const char* const name :
       {"front_leg.L", "FrontLeg.L", "frontleg_l", "FRONTLEGL", "LeftFrontLeg", "leftfrontleg"}) {
    INFO(name);
    CHECK(body::partWords(name) == Words{PartWord::leg, PartWord::front});
  }
  for (const char* const name : {"wing_L", "LeftWing", "LEFTWING2", "leftwing"}) {
    INFO(name);
    CHECK(body::partWords(name) == Words{PartWord::wing});
  }
  CHECK(body::partWords("hindpaw") == Words{PartWord::leg, PartWord::back});
  for (const char* const name : {"leg_FL", "FR_thigh", "thigh.f.l", "shin.f.r"}) {
    CAPTURE(name);
    CHECK(body::partWords(name) == Words{PartWord::leg, PartWord::front});
  }
  for (const char* const name : {"leg_BL", "HR_thigh", "thigh.r.l", "shin.r.r", "RL.foot"}) {
    CAPTURE(name);
    CHECK(body::partWords(name) == Words{PartWord::leg, PartWord::back});
  }
  CHECK(body::partWords("leg.l") == Words{PartWord::leg}); // one letter is a side alone
  CHECK(body::partWords("Bone_FL").empty());
  // Words that only begin or end as a part does.
  for (const char* const name : {"tailor", "warm", "pinear", "legato", "Bone.003", ""}) {
    INFO(name);
    CHECK(body::partWords(name).empty());
  }
}

TEST_CASE("A winged body whose legs have no joints is an insect, and one with a tail a bird") {
  const bool hasTail = GENERATE(false, true);
  SyntheticBiped body;
  const auto add = [&](const std::string& key, const std::string& parent, const Vec3& place) {
    body.joints.push_back({key, parent, place});
  };
  add("Body", "", {0, 0.5, 0});
  add("Mouth", "Body", {0, 0.5, 0.5});
  add("Head", "", {0, 0.7, 0.3});
  add("Head2", "Head", {0, 1.0, 0.35});
  add("Head3", "Head2", {0, 1.2, 0.4});
  for (const auto& [side, sign] : {std::pair(std::string(".L"), 1.0), std::pair(std::string(".R"), -1.0)}) {
    add("Wing1" + side, "Head", {0.2 * sign, 0.8, 0.0});
    add("Wing2" + side, "Wing1" + side, {0.8 * sign, 1.0, -0.1});
  }
  if (hasTail) {
    add("Tail1", "Body", {0, 0.5, -0.3});
    add("Tail2", "Tail1", {0, 0.5, -0.6});
  }
  nameByKeys(body);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == (hasTail ? "bird" : "insect"));
  CHECK(describe(built, read, {LimbKind::wing, LimbSide::left}) == "Wing1.L -> Wing2.L");
  CHECK((findLimb(read, {LimbKind::tail}) != nullptr) == hasTail);
  REQUIRE(read.warnings.size() == 2);
  CHECK(read.warnings.front().starts_with("no legs found"));
  CHECK(read.warnings.back() == "guessed, and not sure: spine");
  CHECK(read.planConfidence >= 0.5);
  REQUIRE(findLimb(read, biped::spine) != nullptr);
  CHECK(findLimb(read, biped::spine)->confidence < 0.5);
  for (const char* const side : {".L", ".R"}) {
    body.names[std::string("Wing1") + side] = "WingRoot";
    body.names[std::string("Wing2") + side] = "WingEnd";
  }
  CHECK(warnsOf(detectBody(build(body).scene), "no name tells left from right"));
}

TEST_CASE("A character that is bound a thousandth of a unit high stands as its binds say") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  body.posedAtRest = true; // so that the rest tells another story
  body.size = 0.01;
  body.armatureScale = 100.0;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  const std::vector<Mat4> worlds = bindPoseWorlds(built.scene);
  CHECK(positionOf(worlds[at(built.node.at("spine2"))]).x == Approx(0.0).margin(1e-6));
}

TEST_CASE("The collar of a body that is far wider than high is no foot, though it is near the ground") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    for (int i = 0; i < 5; ++i) {
      const std::string key = "wing" + std::to_string(i) + side;
      const std::string parent = i == 0 ? std::string("spine1") : "wing" + std::to_string(i - 1) + side;
      body.joints.push_back({key, parent, Vec3(sign * (0.2 + 1.5 * i), 1.5, 0.2)});
      body.names[key] = key;
    }
    body.joints.push_back({"anchor" + side, "spine1", Vec3(0.0, 1.4, 0.35), true, false});
    jointOf(body, "scapula" + side).parent = "anchor" + side;
  }
  body.joints.push_back({"stomach", "spine0", Vec3(0.0, 1.1, -0.1)});
  body.joints.push_back({"belly", "stomach", Vec3(0.0, 1.05, 0.3)});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "quadruped");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}).starts_with("scapula.l forearmLeg.l"));
  CHECK(describe(built, read, biped::neck) == "neck0 neck1 -> head");
  CHECK(read.height == Approx(2.2).margin(0.3)); // along up, however wide the wings are
}

TEST_CASE("An arm without a counterpart is found without names, and the other one told as missing") {
  SyntheticBiped body = makeNamedBody("no names");
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key.ends_with(".r") &&
           (joint.key.starts_with("upperArm") || joint.key.starts_with("foreArm") ||
            joint.key.starts_with("hand") || joint.key.starts_with("finger"));
  });
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(findLimb(read, biped::rightArm) == nullptr);
  CHECK(std::ranges::any_of(read.warnings,
                            [](const std::string& line) { return line.starts_with("no right-arm found"); }));
}

TEST_CASE("A raised arm with all its fingers does not tilt the plane between left and right") {
  SyntheticBiped body = makeBody();
  applyNames(body, namingScheme("Mixamo"));
  for (SyntheticJoint& joint : body.joints) {
    const bool isArm =
        joint.key.starts_with("foreArm") || joint.key.starts_with("hand") || joint.key.starts_with("finger");
    if (isArm) { // up on the left, down on the right
      const double sign = joint.position.x < 0.0 ? -1.0 : 1.0;
      const double out = std::abs(joint.position.x) - 0.18;
      joint.position = {sign * (0.18 + 0.3 * out), 1.43 + sign * 0.95 * out, joint.position.z};
    }
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK_FALSE(asksForSides(read));
}

TEST_CASE("A foot on the root ends a shin of many halves, each of them shorter than the foot") {
  eachScheme(
      [](SyntheticBiped& body) {
        for (const std::string side : {".l", ".r"}) {
          std::string above = "shin" + side;
          for (int i = 0; i < 3; ++i) {
            const std::string half = "shinHalf" + std::to_string(i) + side;
            addTwist(body, half, above, "foot" + side, 1.0 / (4 - i), true);
            above = half;
          }
          jointOf(body, "foot" + side).parent = "root";
        }
      },
      [](const BuiltBiped& built, const Body& body) {
        for (const LimbPlace& leg : {biped::leftLeg, biped::rightLeg}) {
          CHECK(describe(built, body, leg) ==
                (leg == biped::leftLeg ? "thigh.l shin.l -> foot.l" : "thigh.r shin.r -> foot.r"));
        }
      });
}

TEST_CASE("What spreads beside the legs of an insect are wings, without names as well") {
  SyntheticBiped body = makeManyLegged(3);
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    body.joints.push_back({"wing0" + side, "thorax", {sign * 0.1, 0.6, 0.0}});
    body.joints.push_back({"wing1" + side, "wing0" + side, {sign * 0.7, 0.7, -0.1}});
    body.joints.push_back({"wing2" + side, "wing1" + side, {sign * 1.3, 0.75, -0.2}});
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(read.plan == "insect");
  CHECK(describe(built, read, {LimbKind::wing, LimbSide::left}) == "wing0.l wing1.l -> wing2.l");
  CHECK(describe(built, read, {LimbKind::feeler, LimbSide::left}).starts_with("antenna"));
}

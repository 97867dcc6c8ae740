#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Not a biped, and told on how many legs it stands.
void checkNoBiped(const Body& body, const std::string& plan, const std::string& legs) {
  CHECK_FALSE(body.isBiped);
  CHECK(body.plan == plan);
  CHECK(std::ranges::any_of(body.planReasons, [&](const std::string& reason) {
    return reason.find("stands on " + legs + " legs") != std::string::npos;
  }));
  const auto legCount = std::ranges::count(body.limbs, LimbKind::leg, &Limb::kind);
  CHECK(std::to_string(legCount) == legs);
}

struct Point {
  const char* key;
  const char* parent;
  Vec3 position;
};

void add(SyntheticBiped& body, const std::vector<Point>& points) {
  for (const Point& point : points) {
    const std::string key = point.key;
    if (std::abs(point.position.x) < 1e-9) {
      body.joints.push_back({key, point.parent, point.position});
      continue;
    }
    for (const double sign : {1.0, -1.0}) {
      const std::string side = sign > 0.0 ? ".l" : ".r";
      const std::string parent = point.parent;
      const bool paired = std::ranges::any_of(points, [&](const Point& other) {
        return parent == other.key && std::abs(other.position.x) > 0.0;
      });
      body.joints.push_back({key + side, paired ? parent + side : parent,
                             Vec3(sign * point.position.x, point.position.y, point.position.z)});
    }
  }
}

// A horse: long legs of four bones, shoulder blades beside the ribs, the head carried high.
SyntheticBiped horse() {
  SyntheticBiped body;
  add(body, {{"hips", "", {0, 1.4, -0.6}},
             {"spine0", "hips", {0, 1.45, -0.2}},
             {"spine1", "spine0", {0, 1.42, 0.2}},
             {"neck0", "spine1", {0, 1.5, 0.6}},
             {"neck1", "neck0", {0, 1.9, 0.85}},
             {"head", "neck1", {0, 2.2, 1.0}},
             {"muzzle", "head", {0, 1.95, 1.35}},
             {"tail0", "hips", {0, 1.4, -0.85}},
             {"tail1", "tail0", {0, 1.1, -1.0}},
             {"clavicle", "spine1", {0.1, 1.5, 0.35}},
             {"upperArm", "clavicle", {0.2, 1.05, 0.6}},
             {"foreArm", "upperArm", {0.2, 0.85, 0.4}},
             {"hand", "foreArm", {0.2, 0.45, 0.42}},
             {"hoof", "hand", {0.2, 0.1, 0.45}},
             {"thigh", "hips", {0.18, 1.25, -0.65}},
             {"shin", "thigh", {0.2, 0.9, -0.45}},
             {"hock", "shin", {0.2, 0.55, -0.8}},
             {"foot", "hock", {0.2, 0.2, -0.72}},
             {"toe", "foot", {0.2, 0.05, -0.66}}});
  return body;
}

// Eight legs that rise from a low body and come down again.
SyntheticBiped spider() {
  SyntheticBiped body;
  add(body,
      {{"hips", "", {0, 0.5, 0}}, {"abdomen", "hips", {0, 0.6, -0.4}}, {"head", "hips", {0, 0.5, 0.4}}});
  for (int leg = 0; leg < 4; ++leg) {
    const double z = 0.3 - 0.2 * leg;
    const std::string n = std::to_string(leg);
    const std::string a = "a" + n;
    const std::string b = "b" + n;
    const std::string c = "c" + n;
    add(body, {{a.c_str(), "hips", {0.2, 0.5, z}}});
    for (const double sign : {1.0, -1.0}) {
      const std::string side = sign > 0.0 ? ".l" : ".r";
      body.joints.push_back({b + side, a + side, Vec3(sign * 0.7, 1.1, 2.0 * z)});
      body.joints.push_back({c + side, b + side, Vec3(sign * 1.2, 0.5, 3.0 * z)});
      body.joints.push_back({"d" + n + side, c + side, Vec3(sign * 1.4, 0.02, 3.4 * z)});
    }
  }
  return body;
}

const NamingScheme animal{"animal",
                          "L",
                          "R",
                          {{"hips", "Bip01 Pelvis"},
                           {"spine0", "Bip01 Spine"},
                           {"spine1", "Bip01 Spine1"},
                           {"neck0", "Bip01 Neck"},
                           {"neck1", "Bip01 Neck1"},
                           {"head", "Bip01 Head"},
                           {"clavicle", "Bip01 % Clavicle"},
                           {"upperArm", "Bip01 % UpperArm"},
                           {"foreArm", "Bip01 % Forearm"},
                           {"hand", "Bip01 % Hand"},
                           {"thigh", "Bip01 % Thigh"},
                           {"shin", "Bip01 % Calf"},
                           {"hock", "Bip01 % HorseLink"},
                           {"foot", "Bip01 % Foot"},
                           {"toe", "Bip01 % Toe0"}}};

} // namespace

TEST_CASE("a horse stands on four legs, whatever its joints are called") {
  SyntheticBiped body = horse();
  if (GENERATE(true, false)) {
    applyNames(body, animal);
  }
  body.withMesh = GENERATE(true, false);
  checkNoBiped(detectBody(build(body).scene), "quadruped", "4");
}

TEST_CASE("a cat, low and long, stands on four legs") {
  SyntheticBiped body = horse();
  for (SyntheticJoint& joint : body.joints) {
    joint.position = Vec3(0.6 * joint.position.x, 0.35 * joint.position.y, 0.7 * joint.position.z);
  }
  if (GENERATE(true, false)) {
    applyNames(body, animal);
  }
  checkNoBiped(detectBody(build(body).scene), "quadruped", "4");
}

TEST_CASE("a spider stands on eight legs") {
  checkNoBiped(detectBody(build(spider()).scene), "spider", "8");
}

TEST_CASE("the trunk of a human laid down on arms that reach the ground is four-legged") {
  SyntheticBiped body = makeBody({.clavicles = false, .fingers = false});
  for (SyntheticJoint& each : body.joints) {
    const std::string stem = each.key.substr(0, each.key.find('.'));
    const double sign = each.key.ends_with(".l") ? 1.0 : -1.0;
    if (stem == "upperArm") {
      each.position = Vec3(sign * 0.1, 0.92, 0.9);
    } else if (stem == "foreArm") {
      each.position = Vec3(sign * 0.1, 0.5, 0.92);
    } else if (stem == "hand") {
      each.position = Vec3(sign * 0.1, 0.08, 0.9);
    } else if (stem.starts_with("spine") || stem.starts_with("neck") || stem == "head") {
      each.position = Vec3(0, 1.0, each.position.y - 0.5);
    }
  }
  if (GENERATE(true, false)) {
    applyNames(body, namingScheme("Mixamo"));
  }
  checkNoBiped(detectBody(build(body).scene), "quadruped", "4");
}

TEST_CASE("a biped in a low stance whose hands reach the ground is a biped") {
  SyntheticBiped body = makeBody({.clavicles = false, .fingers = false});
  for (const std::string side : {".l", ".r"}) {
    const double sign = side == ".l" ? 1.0 : -1.0;
    jointOf(body, "thigh" + side).position = Vec3(sign * 0.12, 0.5, -0.1);
    jointOf(body, "shin" + side).position = Vec3(sign * 0.25, 0.45, 0.3);
    jointOf(body, "foot" + side).position = Vec3(sign * 0.2, 0.09, 0.05);
    jointOf(body, "toe" + side).position = Vec3(sign * 0.2, 0.02, 0.18);
    jointOf(body, "upperArm" + side).position = Vec3(sign * 0.25, 0.9, 0.15);
    jointOf(body, "foreArm" + side).position = Vec3(sign * 0.35, 0.5, 0.2);
    jointOf(body, "hand" + side).position = Vec3(sign * 0.35, 0.12, 0.3);
  }
  jointOf(body, "hips").position = Vec3(0, 0.55, -0.1);
  jointOf(body, "spine0").position = Vec3(0, 0.65, -0.05);
  jointOf(body, "spine1").position = Vec3(0, 0.75, 0.05);
  jointOf(body, "spine2").position = Vec3(0, 0.88, 0.12);
  jointOf(body, "neck0").position = Vec3(0, 0.98, 0.18);
  jointOf(body, "head").position = Vec3(0, 1.05, 0.25);
  applyNames(body, namingScheme("Mixamo"));
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE("coat tails that reach the ground are no legs") {
  SyntheticBiped body = makeBody();
  applyNames(body, namingScheme("Mixamo"));
  for (const std::string side : {".l", ".r"}) {
    const double sign = side == ".l" ? 1.0 : -1.0;
    body.joints.push_back({"tail0" + side, "hips", Vec3(sign * 0.08, 0.95, -0.15)});
    body.joints.push_back({"tail1" + side, "tail0" + side, Vec3(sign * 0.08, 0.5, -0.2)});
    body.joints.push_back({"tail2" + side, "tail1" + side, Vec3(sign * 0.08, 0.05, -0.22)});
  }
  const BuiltBiped built = build(body);
  checkArmsAndLegs(built, detectBody(built.scene));
}

TEST_CASE("A biped has the tail that its names or its shape tell, and none of what it wears") {
  const std::string name =
      GENERATE("Tail", "Bone", "CoatTail", "Skirt", "Sword", "Quiver", "Scarf", "Sheath", "Ponytail");
  CAPTURE(name);
  SyntheticBiped body = makeBody();
  applyNames(body, namingScheme("Mixamo"));
  std::string above = "hips";
  for (int i = 0; i < 4; ++i) {
    const std::string key = "row" + std::to_string(i);
    body.joints.push_back({key, above, Vec3(0, 0.95 - 0.02 * i, -0.15 - 0.15 * i)});
    body.names[key] = name + std::to_string(i);
    above = key;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  const bool isTail = name == "Tail" || name == "Bone";
  CHECK(describe(built, read, {LimbKind::tail}) == (isTail ? "row0 row1 row2 -> row3" : "none"));
}

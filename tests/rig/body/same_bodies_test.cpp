// Bodies that are the same but for their size, the order of their nodes or their sides are read alike, odd
// ones too.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::string otherSide(std::string key) {
  if (key.ends_with(".l") || key.ends_with(".r")) {
    key.back() = key.back() == 'l' ? 'r' : 'l';
  }
  return key;
}

/// The body in a mirror: what was left is right.
SyntheticBiped mirroredBody(const SyntheticBiped& body, const std::map<std::string, std::string>& allNames) {
  SyntheticBiped mirrored = body;
  mirrored.names.clear();
  for (SyntheticJoint& joint : mirrored.joints) {
    const auto name = allNames.find(otherSide(joint.key));
    if (body.names.contains(joint.key) && name != allNames.end()) {
      mirrored.names[otherSide(joint.key)] = name->second;
    }
    joint.key = otherSide(joint.key);
    joint.parent = otherSide(joint.parent);
    joint.position.x *= -1.0;
    joint.flesh.x *= -1.0;
  }
  return mirrored;
}

/// The plan, and each limb with its joints by their keys, sides swapped or not.
std::vector<std::string> readingOf(const BuiltBiped& built, bool isMirrored = false) {
  const Body found = detectBody(built.scene);
  const auto keyOfNode = [&](NodeIndex node) {
    const std::string key = node.exists() ? keyOf(built, node) : "none";
    return isMirrored ? otherSide(key) : key;
  };
  std::vector<std::string> lines;
  for (const Limb& limb : found.limbs) {
    const LimbPlace place = isMirrored ? mirrored(limb) : LimbPlace{limb.kind, limb.side, limb.row};
    std::string line = limbName(place) + " " + std::to_string(place.row) + ":";
    for (const NodeIndex joint : limb.joints) {
      line += " " + keyOfNode(joint);
    }
    lines.push_back(line + " -> " + keyOfNode(limb.endNode));
  }
  std::ranges::sort(lines);
  lines.push_back(found.plan + ", hips " + keyOfNode(found.hips) + ", head " + keyOfNode(found.head));
  return lines;
}

std::vector<std::string> sidedReadingOf(const SyntheticBiped& body, bool isMirrored = false) {
  return readingOf(build(body), isMirrored);
}

/// The body at another place of the scene, in its bind pose and at rest.
BuiltBiped movedBody(BuiltBiped built, const Vec3& way) {
  built.scene.nodes[0].rest.translation += way;
  for (Mat4& inverse : built.scene.skins.at(0).inverseBind) {
    inverse = glm::translate(inverse, -way);
  }
  for (glm::vec3& place : built.scene.meshes.at(0).primitives.at(0).positions) {
    place += glm::vec3(way);
  }
  return built;
}

/// Some joints stand elsewhere, some lack their names, and some in the middle of the body are more.
SyntheticBiped odd(SyntheticBiped body, Row& row) {
  for (SyntheticJoint& joint : body.joints) {
    joint.position += row.vector(0.02);
    if (row.once(6)) {
      body.names.erase(joint.key);
    }
  }
  for (std::uint32_t more = row.below(3); more > 0; --more) {
    const SyntheticJoint above = row.oneOf(body.joints);
    if (otherSide(above.key) == above.key) {
      body.joints.push_back({"more" + std::to_string(more), above.key, above.position + row.vector(0.2)});
    }
  }
  return body;
}

struct Case {
  std::string title;
  SyntheticBiped body;
  std::map<std::string, std::string> names; ///< Of all joints, those that lost theirs among them.
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* const title : {"Mixamo", "no names"}) {
    const SyntheticBiped body = makeNamedBody(title);
    all.push_back({title, body, body.names});
  }
  for (Creature& creature : creatures()) {
    nameByKeys(creature.body);
    all.push_back({creature.title, creature.body, creature.body.names});
    creature.body.names.clear();
    all.push_back({creature.title + ", no names", creature.body, {}});
  }
  Row row(41);
  const std::vector<Case> plain = all;
  for (std::size_t i = 0; i < 3 * plain.size(); ++i) {
    const Case& from = plain[i % plain.size()];
    if (!from.names.empty()) { // Else a spider's front is anyone's guess.
      all.push_back({from.title + ", odd " + std::to_string(i), odd(from.body, row), from.names});
    }
  }
  return all;
}

} // namespace

TEST_CASE("A body is read alike whatever its size, and in whatever order its nodes stand") {
  for (const Case& one : cases()) {
    CAPTURE(one.title);
    const std::vector<std::string> plain = sidedReadingOf(one.body);
    SyntheticBiped other = one.body;
    for (const double size : {32.0, 1.0 / 32.0}) { // To the last bit.
      other.size = size;
      CHECK(sidedReadingOf(other) == plain);
    }
    other = one.body;
    other.shuffled = true;
    CHECK(sidedReadingOf(other) == plain);
    other = one.body;
    other.armatureScale = 0.25;
    CHECK(sidedReadingOf(other) == plain);
  }
}

TEST_CASE("A body is read alike wherever it stands") {
  for (const Case& one : cases()) {
    CAPTURE(one.title);
    const std::vector<std::string> plain = sidedReadingOf(one.body);
    for (const Vec3& way : {Vec3(16.0, 0.0, 0.0), Vec3(-8.0, 0.0, -16.0)}) {
      CAPTURE(way.x);
      CHECK(readingOf(movedBody(build(one.body), way)) == plain);
    }
  }
}

TEST_CASE("A body that names tell is read alike whichever way it faces") {
  for (const Case& one : cases()) {
    CAPTURE(one.title);
    SyntheticBiped turned = one.body;
    for (const auto& [quarters, size] :
         {std::pair(1.0, 32.0), std::pair(2.0, 1.0), std::pair(3.0, 1.0 / 32.0)}) {
      CAPTURE(quarters, size);
      turned.turn = axisAngle(Vec3(0.0, 1.0, 0.0), quarters * pi / 2.0);
      turned.size = size;
      if (!one.names.empty()) {
        CHECK(sidedReadingOf(turned) == sidedReadingOf(one.body));
      }
    }
  }
}

TEST_CASE("A body in a mirror is read with its sides changed") {
  for (const Case& one : cases()) {
    CAPTURE(one.title);
    CHECK(sidedReadingOf(mirroredBody(one.body, one.names), true) == sidedReadingOf(one.body));
  }
}

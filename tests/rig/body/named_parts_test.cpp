// Bodies whose names tell what their shape leaves open: what stands beside their limbs, and where these
// begin.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct NamedJoint {
  std::string key;
  std::string parent; // with "%" where the side stands
  Vec3 place;         // on the left
};

void addCalled(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  body.joints.push_back({key, parent, place});
  body.names[key] = key;
}

// Called by their keys, on both sides.
void addCalledPairs(SyntheticBiped& body, const std::vector<NamedJoint>& joints) {
  for (const auto& [side, sign] : sides) {
    for (const NamedJoint& joint : joints) {
      std::string parent = joint.parent;
      if (const std::size_t mark = parent.find('%'); mark != std::string::npos) {
        parent.replace(mark, 1, side);
      }
      addCalled(body, joint.key + side, parent, {sign * joint.place.x, joint.place.y, joint.place.z});
    }
  }
}

void drop(SyntheticBiped& body, const std::vector<std::string>& stems) {
  std::erase_if(body.joints, [&](const SyntheticJoint& joint) {
    return std::ranges::any_of(stems, [&](const std::string& stem) { return joint.key.starts_with(stem); });
  });
}

bool warnsOf(const Body& body, const std::string& words) {
  return std::ranges::any_of(
      body.warnings, [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

// Everything is called by its key.
SyntheticBiped namedPerson() {
  SyntheticBiped body = makeBody({.fingers = false});
  nameByKeys(body);
  return body;
}

} // namespace

TEST_CASE("An insect's front legs are no arms of a person") {
  SyntheticBiped body = makeManyLegged(3);
  nameByKeys(body);
  const std::vector<std::string> rows{"LegFront", "LegMid", "LegBack"};
  for (const auto& [side, sign] : sides) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      int number = 1;
      for (const char* const part : {"coxa", "femur", "tibia", "tarsus"}) {
        body.names[part + std::to_string(row) + side] = rows[row] + std::to_string(number++) + side;
      }
    }
  }
  const Body read = detectBody(build(body).scene);
  CHECK(read.plan == "insect");
  CHECK(read.planConfidence > 0.5);
}

TEST_CASE("A joint of the face in the head's own place does not tell where it points") {
  SyntheticBiped body = namedPerson();
  addCalled(body, "Face_Root", "head", jointOf(body, "head").position + Vec3(0.0, 0.0, -1e-6));
  addCalledPairs(body, {{"Eye", "Face_Root", {0.03, 1.66, 0.1}}});
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  checkArmsAndLegs(built, read);
  CHECK(!warnsOf(read, "point the other way"));
  CHECK(findLimb(read, biped::leftArm)->confidence > 0.9);
}

// Parts beside the limbs of a body: rows that go back, tufts, crests, and legs that are drawn up.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::string described(const SyntheticBiped& body, const LimbPlace& place) {
  const BuiltBiped built = build(body);
  return describe(built, detectBody(built.scene), place);
}

/// A person with a row of five nameless joints that goes back from the hips.
SyntheticBiped withRowBehind() {
  SyntheticBiped body = makeNamedBody("Mixamo");
  const Vec3 hips = jointOf(body, "hips").position;
  std::string parent = "hips";
  for (int i = 0; i < 5; ++i) {
    const std::string key = "behind" + std::to_string(i);
    body.joints.push_back({key, parent, hips + Vec3(0.0, -0.02 * i, -0.12 - 0.14 * i)});
    parent = key;
  }
  return body;
}

} // namespace

TEST_CASE("A nameless row that goes back from a person's hips is a tail, and one that forks is none") {
  CHECK(described(withRowBehind(), {LimbKind::tail}) == "behind0 behind1 behind2 behind3 -> behind4");
  for (const int at : {0, 2, 3}) {
    CAPTURE(at);
    SyntheticBiped forked = withRowBehind();
    const std::string key = "behind" + std::to_string(at);
    forked.joints.push_back({"fork", key, jointOf(forked, key).position + Vec3(0.0, -0.05, -0.02)});
    CHECK(described(forked, {LimbKind::tail}) == "none");
  }
  SyntheticBiped aside = withRowBehind();
  jointOf(aside, "behind2").position.x += 0.1;
  CHECK(described(aside, {LimbKind::tail}) == "none");
  SyntheticBiped ahead = withRowBehind();
  for (int i = 0; i < 5; ++i) {
    Vec3& place = jointOf(ahead, "behind" + std::to_string(i)).position;
    place.z = -place.z;
  }
  CHECK(described(ahead, {LimbKind::tail}) == "none");
}

TEST_CASE("Front legs hang before hind legs wherever their hooves stand") {
  SyntheticBiped gathered = makeHorse();
  for (const std::string side : {".l", ".r"}) {
    for (const char* const front : {"frontPastern", "frontHoof"}) {
      jointOf(gathered, front + side).position.z -= 1.1;
    }
    for (const char* const hind : {"pastern", "hoof"}) {
      jointOf(gathered, hind + side).position.z += 1.1;
    }
  }
  for (const bool isNamed : {true, false}) {
    CAPTURE(isNamed);
    if (isNamed) {
      nameByKeys(gathered);
    } else {
      gathered.names.clear();
    }
    const BuiltBiped built = build(gathered);
    const Body read = detectBody(built.scene);
    CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}) ==
          "scapula.l forearmLeg.l frontKnee.l frontPastern.l -> frontHoof.l");
    CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 2}) ==
          "thigh.l calf.l hock.l pastern.l -> hoof.l");
  }
}

TEST_CASE("Many strands about the middle of a body do not tell where its sides are") {
  SyntheticBiped body = makeBody();
  Row row(17);
  for (int strand = 0; strand < 14; ++strand) {
    const std::string key = "strand" + std::to_string(strand);
    const Vec3 root = jointOf(body, "hips").position + row.vector(0.1);
    body.joints.insert(body.joints.begin() + 2, {key + "end", key, root + Vec3(0.0, -0.08, 0.0)});
    body.joints.insert(body.joints.begin() + 2, {key, "hips", root});
  }
  for (const double quarters : {0.0, 1.0}) {
    CAPTURE(quarters);
    body.turn = axisAngle(Vec3(0.0, 1.0, 0.0), quarters * pi / 2.0);
    const BuiltBiped built = build(body);
    checkArmsAndLegs(built, detectBody(built.scene));
  }
}

TEST_CASE("A long row of joints with two pairs of long limbs is no serpent, and with one pair it is") {
  SyntheticBiped body = makeSnake();
  const auto addPair = [&](const std::string& name, const std::string& parent, double z) {
    for (const double sign : {1.0, -1.0}) {
      const std::string side = sign > 0.0 ? ".l" : ".r";
      for (int i = 0; i < 3; ++i) {
        const std::string above = i == 0 ? parent : name + std::to_string(i - 1) + side;
        body.joints.push_back({name + std::to_string(i) + side, above, {sign * (0.1 + 0.4 * i), 0.06, z}});
      }
    }
  };
  const auto plan = [&] { return detectBody(build(body).scene).plan; };
  CHECK(plan() == "serpent");
  addPair("fore", "segment11", 0.6);
  CHECK(plan() == "serpent");
  addPair("hind", "segment4", -0.4);
  CHECK(plan() != "serpent");
}

TEST_CASE("A mane on the back of a beast is not its head, though it is as long as the neck") {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  for (const char* const key : {"head", "jaw", "neck0", "neck1"}) {
    body.names[key] = "";
  }
  const std::string plain = described(body, {LimbKind::neck});
  REQUIRE(plain != "none");
  Vec3 place = jointOf(body, "spine1").position;
  std::string parent = "spine1";
  for (int i = 0; i < 4; ++i) {
    place += Vec3(0.0, 0.24, 0.02);
    const std::string key = "mane" + std::to_string(i);
    body.joints.push_back({key, parent, place});
    body.names[key] = "Mane_" + std::to_string(i);
    parent = key;
  }
  CHECK(described(body, {LimbKind::neck}) == plain);
}

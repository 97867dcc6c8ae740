// Rigs as programs export them: several characters under one root, parts of one bone, limbs in other poses.
#include <algorithm>
#include <array>
#include <string>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/body/reading/detection.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/families/family_rig.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

void add(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  body.joints.push_back({key, parent, place});
  body.names[key] = key;
}

void addPair(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  for (const auto& [side, sign] : sides) {
    add(body, key + side, parent, {sign * place.x, place.y, place.z});
  }
}

/// A body of one bone for each limb, as games of blocks have them.
SyntheticBiped ofBlocks() {
  SyntheticBiped body;
  body.tubes = true;
  add(body, "body", "", {0.0, 0.9, 0.0});
  add(body, "head", "body", {0.0, 1.5, 0.0});
  addPair(body, "arm", "body", {0.35, 1.4, 0.0});
  addPair(body, "leg", "body", {0.12, 0.85, 0.0});
  for (const auto& [side, sign] : sides) {
    jointOf(body, "arm" + side).flesh = {0.0, -0.6, 0.0};
    jointOf(body, "leg" + side).flesh = {0.0, -0.84, 0.0};
  }
  jointOf(body, "head").flesh = {0.0, 0.3, 0.0};
  return body;
}

/// A row of nameless joints, each `step` from the one before.
SyntheticBiped rowOf(const Vec3& step) {
  SyntheticBiped body;
  std::string above;
  for (int i = 0; i < 8; ++i) {
    const std::string key = "link" + std::to_string(i);
    add(body, key, above, Vec3(0.0, 0.1, 0.0) + static_cast<double>(i) * step);
    above = key;
  }
  return body;
}

} // namespace

TEST_CASE("Of two persons under one root each limb belongs to one, and the other is told") {
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  addOther(body, makeNamedBody("Mixamo", {.fingers = false}), {1.3, 0.0, 0.2});
  body.joints.insert(body.joints.begin(), {"world", "", Vec3(0.0), true, false});
  jointOf(body, "root").parent = "world";
  jointOf(body, "other root").parent = "world";
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.isBiped);
  CHECK(warnsOf(read, "characters in the file"));
  const bool isOther = keyOf(built, read.hips).starts_with("other ");
  for (const Limb& limb : read.limbs) {
    CAPTURE(limb.id);
    CHECK(keyOf(built, limb.joints.front()).starts_with("other ") == isOther);
  }
}

TEST_CASE("A beast's leg whose last joint is the knee ends where its mesh meets the ground") {
  SyntheticBiped body = makeHorse();
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return std::ranges::any_of(
        std::array{"frontKnee", "frontPastern", "frontHoof", "hock", "pastern", "hoof"},
        [&](const char* stem) { return joint.key.starts_with(stem); });
  });
  body.tubes = true;
  for (const std::string& side : bothSides) {
    jointOf(body, "calf" + side).flesh = {0.0, -0.8, 0.0};
    jointOf(body, "forearmLeg" + side).flesh = {0.0, -0.95, 0.0};
  }
  nameByKeys(body);
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  REQUIRE(read.plan == "quadruped");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::left, 1}) == "scapula.l forearmLeg.l -> estimated");
  CHECK(describe(built, read, {LimbKind::leg, LimbSide::right, 2}) == "thigh.r calf.r -> estimated");
}

TEST_CASE("A hand on the root that is called so ends an arm of three joints, and none that has a hand") {
  const bool isCalledSo = GENERATE(true, false);
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  body.tubes = true;
  for (const auto& [side, sign] : sides) {
    const SyntheticJoint hand = jointOf(body, "hand" + side);
    add(body, "cuff" + side, "foreArm" + side, hand.position - Vec3(sign * 0.04, 0.0, 0.0));
    body.names["cuff" + side] = (side == ".l" ? "LeftArm3" : "RightArm3");
    jointOf(body, "hand" + side).parent = "root";
    add(body, "target" + side, "root", hand.position + Vec3(sign * 0.02, 0.0, 0.0));
    body.names["target" + side] = side == ".l" ? "LeftTarget" : "RightTarget";
    if (!isCalledSo) {
      std::swap(body.names["hand" + side], body.names["cuff" + side]);
    }
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  const std::string end = isCalledSo ? "hand" : "cuff";
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> " + end + ".l");
  CHECK(describe(built, read, biped::rightArm) == "upperArm.r foreArm.r -> " + end + ".r");
}

TEST_CASE("A collar bone by itself is no arm") {
  SyntheticBiped body = ofBlocks();
  for (const std::string& side : bothSides) {
    body.names["arm" + side] = (side == ".l" ? "Left" : "Right") + std::string("Shoulder");
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "none");
  CHECK(warnsOf(read, "no left-arm, right-arm found"));
}

TEST_CASE("What is worn over a limb of one bone is no next joint of it") {
  SyntheticBiped body = ofBlocks();
  addPair(body, "trousers", "leg", jointOf(body, "leg.l").position);
  for (const std::string& side : bothSides) {
    jointOf(body, "trousers" + side).parent = "leg" + side;
    jointOf(body, "trousers" + side).flesh = {0.0, -0.8, 0.0};
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg) == "leg.l -> estimated");
  CHECK(describe(built, read, biped::rightLeg) == "leg.r -> estimated");
}

TEST_CASE(
    "What leads from the joint that carries the arms to the head is the neck, though it is called spine") {
  SyntheticBiped body = makeNamedBody("Unreal");
  body.names["neck0"] = "spine_09";
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::spine) == "spine0 spine1 -> spine2");
  CHECK(describe(built, read, biped::neck) == "neck0 -> head");
}

TEST_CASE("A person with one arm raised has a foot on either side, though collar bones begin in one place") {
  const std::string scheme = GENERATE("no names", "Unreal");
  const double angle = GENERATE(0.3, 0.9); // a plane that leans little is set upright, one that leans more is
                                           // not
  SyntheticBiped body = makeNamedBody(scheme);
  for (const auto& [side, sign] : sides) {
    jointOf(body, "clavicle" + side).position.x = sign * 0.012;
    for (const std::string stem : {"thigh", "shin", "foot", "toe"}) {
      jointOf(body, stem + side).position.x = sign * 0.045;
    }
  }
  turnBelow(body, "upperArm.l", glm::angleAxis(angle, glm::normalize(Vec3(0.3, 0.2, 1.0))));
  body.turn = glm::angleAxis(0.8, Vec3(0.0, 1.0, 0.0));
  body.tubes = true;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, read, biped::rightLeg) == "thigh.r shin.r -> foot.r");
}

TEST_CASE("Where one leg bends at a joint more than the other stands, both have it") {
  const bool leftIsBent = GENERATE(true, false);
  SyntheticBiped body = makeNamedBody("Unreal");
  for (const auto& [side, sign] : sides) {
    const Vec3 knee = jointOf(body, "shin" + side).position;
    const bool isBent = (side == ".l") == leftIsBent;
    add(body, "horselink" + side, "shin" + side,
        0.5 * (knee + jointOf(body, "foot" + side).position) - Vec3(0.0, 0.0, isBent ? 0.1 : 0.0));
    jointOf(body, "foot" + side).parent = "horselink" + side;
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l horselink.l -> foot.l");
  CHECK(describe(built, read, biped::rightLeg) == "thigh.r shin.r horselink.r -> foot.r");
}

TEST_CASE("Limbs whose joints hang side by side in the file are doubted, and say why") {
  SyntheticBiped body = makeNamedBody("Unreal");
  body.tubes = true;
  const auto confidences = [&] {
    const Body read = detectBody(build(body).scene);
    std::vector<double> found;
    for (const LimbPlace& place : {biped::leftArm, biped::rightArm, biped::leftLeg, biped::rightLeg}) {
      const Limb* const limb = limbAt(read.limbs, place);
      REQUIRE(limb != nullptr);
      const bool saysWhy =
          std::ranges::count(limb->reasons,
                             std::string("joints that names call the rest of it hang elsewhere")) == 1;
      CHECK(saysWhy == (limb->confidence < 0.5));
      found.push_back(limb->confidence);
    }
    return found;
  };
  CHECK(std::ranges::min(confidences()) > 0.8);
  for (const auto& [side, sign] : sides) {
    for (const std::string stem : {"foreArm", "hand", "shin", "foot"}) {
      jointOf(body, stem + side).parent.clear();
    }
  }
  CHECK(std::ranges::max(confidences()) < 0.5);
}

TEST_CASE("An arm of one bone is none that is cut short where the other arm alone has a forearm") {
  SyntheticBiped body = makeNamedBody("Unreal", {.fingers = false});
  body.tubes = true;
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key == "hand.l" || joint.key == "foreArm.l";
  });
  jointOf(body, "upperArm.l").flesh = {0.4, 0.0, 0.0};
  const Body read = detectBody(build(body).scene);
  const Limb* const arm = limbAt(read.limbs, biped::leftArm);
  REQUIRE(arm != nullptr);
  REQUIRE(arm->joints.size() == 1);
  CHECK(std::ranges::count(arm->reasons,
                           std::string("joints that names call the rest of it hang elsewhere")) == 0);
}

TEST_CASE("A pair of limbs of which one is far longer is doubted, one that differs a little is not") {
  const double longer = GENERATE(1.2, 1.5);
  const std::string base = GENERATE("thigh", "upperArm");
  SyntheticBiped body = makeNamedBody("Unreal");
  const bool isLeg = base == "thigh";
  for (const auto& [key, parent] :
       {std::pair(isLeg ? "foot.l" : "hand.l", isLeg ? "shin.l" : "foreArm.l"),
        std::pair(isLeg ? "shin.l" : "foreArm.l", isLeg ? "thigh.l" : "upperArm.l")}) {
    moveBelow(body, key, (longer - 1.0) * (jointOf(body, key).position - jointOf(body, parent).position));
  }
  const Body read = detectBody(build(body).scene);
  const bool isDoubted = longer > 1.3;
  const Limb& left = *limbAt(read.limbs, isLeg ? biped::leftLeg : biped::leftArm);
  const Limb& right = *limbAt(read.limbs, isLeg ? biped::rightLeg : biped::rightArm);
  CHECK((left.confidence < 0.5) == isDoubted);
  CHECK((right.confidence < 0.5) == isDoubted);
  CHECK(std::ranges::count(left.reasons, std::string("far from as long as the limb on the other side")) ==
        (isDoubted ? 1 : 0));
}

TEST_CASE("A person who bends to one side has both arms, though both begin on that side") {
  const std::string scheme = GENERATE("Unreal", "Mixamo");
  const double angle = GENERATE(-1.0, 0.7, 0.9, 1.1);
  SyntheticBiped body = makeNamedBody(scheme);
  turnBelow(body, "spine0", glm::angleAxis(angle, Vec3(0.0, 0.0, 1.0)));
  body.tubes = true;
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, read, biped::rightArm) == "upperArm.r foreArm.r -> hand.r");
  CHECK(describe(built, read, biped::leftLeg) == "thigh.l shin.l -> foot.l");
}

TEST_CASE("A row of joints that stands upright is doubted as a serpent, one that lies is none") {
  CHECK(warnsOf(detectBody(build(rowOf({0.0, 0.2, 0.02})).scene), "read as a serpent"));
  CHECK_FALSE(warnsOf(detectBody(build(rowOf({0.0, 0.01, 0.2})).scene), "read as a serpent"));
}

TEST_CASE("Sides that names alone tell are asked where a negative scale mirrors the skeleton") {
  SyntheticBiped body = makeNamedBody("Unreal", {.toes = false, .fingers = false});
  body.withMesh = false;
  for (SyntheticJoint& joint : body.joints) {
    joint.position.z = 0.0;
  }
  CHECK_FALSE(warnsOf(detectBody(build(body).scene), "negative scale"));
  body.armatureScale = -1.0;
  CHECK(warnsOf(detectBody(build(body).scene), "negative scale"));
}

TEST_CASE(
    "A joint called foot from which the leg goes on as far as it came is its knee, a foot ahead is its end") {
  const bool isKnee = GENERATE(true, false);
  SyntheticBiped body = ofBlocks();
  for (const auto& [side, sign] : sides) {
    const Vec3 thigh = jointOf(body, "leg" + side).position;
    jointOf(body, "leg" + side).flesh = {0.0, -0.42, 0.0};
    body.names["leg" + side] = "thigh" + side;
    add(body, "foot" + side, "leg" + side, thigh + (isKnee ? Vec3(0.0, -0.42, 0.0) : Vec3(0.0, -0.8, 0.0)));
    jointOf(body, "foot" + side).flesh = isKnee ? Vec3(0.0, -0.42, 0.0) : Vec3(0.0, 0.0, 0.6);
  }
  const BuiltBiped built = build(body);
  const Body read = detectBody(built.scene);
  CHECK(describe(built, read, biped::leftLeg) == (isKnee ? "leg.l foot.l -> estimated" : "leg.l -> foot.l"));
  CHECK(describe(built, read, biped::rightLeg) == (isKnee ? "leg.r foot.r -> estimated" : "leg.r -> foot.r"));
}

TEST_CASE("A neck ends at its head though the head's mesh follows the neck") {
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  jointOf(body, "head").movesMesh = false;
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), biped::neck) == "neck0 -> head");
}

TEST_CASE("A spine that begins where the hips stand, and hangs beside them, begins there") {
  const std::string above = GENERATE("", "world");
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  body.joints.insert(body.joints.begin(), {"world", "", Vec3(0.0)});
  for (const char* const key : {"hips", "spine0"}) {
    jointOf(body, key).parent = above;
  }
  jointOf(body, "spine0").position = jointOf(body, "hips").position;
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), biped::spine) == "spine0 spine1 -> spine2");
}

TEST_CASE("What carries one leg alone is no hips") {
  SyntheticBiped body = makeNamedBody("Mixamo", {.fingers = false});
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key == "thigh.r" || joint.key == "shin.r" || joint.key == "foot.r" || joint.key == "toe.r";
  });
  const Vec3 thigh = jointOf(body, "thigh.l").position;
  add(body, "holder", "", thigh + Vec3(0.0, 0.15, 0.0));
  jointOf(body, "thigh.l").parent = "holder";
  const BuiltBiped built = build(body);
  CHECK(describe(built, detectBody(built.scene), biped::spine) == "spine0 spine1 -> spine2");
}

TEST_CASE("A joint called tip that moves a mesh is none where an exporter's end joint hangs from it") {
  const bool hasEnds = GENERATE(true, false);
  SyntheticBiped body = makeHorse();
  std::string last;
  for (int i = 0; std::ranges::count(body.joints, "tail" + std::to_string(i), &SyntheticJoint::key) > 0;
       ++i) {
    last = "tail" + std::to_string(i);
    body.names[last] = last;
  }
  const Vec3 place = jointOf(body, last).position;
  body.names[last] = "tail_tip";
  if (hasEnds) {
    SyntheticJoint end{"end", last,
                       place + 0.5 * (place - jointOf(body, jointOf(body, last).parent).position)};
    end.isJoint = end.movesMesh = false;
    body.joints.push_back(end);
    body.names["end"] = "tail_tip_end";
  }
  const BuiltBiped built = build(body);
  const std::string tail = describe(built, detectBody(built.scene), {LimbKind::tail});
  CHECK((tail.find(last + " -> end") != std::string::npos) == hasEnds);
  CHECK((hasEnds || tail.ends_with(" -> " + last)));
}

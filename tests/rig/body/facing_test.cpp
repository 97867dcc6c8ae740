#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// A flat biped with straight limbs and without toes, fingers and mesh: nothing tells which way it faces.
SyntheticBiped featureless() {
  SyntheticBiped body = makeBody({.toes = false, .fingers = false});
  body.withMesh = false;
  for (SyntheticJoint& joint : body.joints) {
    joint.position.z = 0.0;
  }
  return body;
}

std::string leftBase(const BuiltBiped& built, const Body& biped) {
  const std::string found = describe(built, biped, biped::leftArm);
  return found.substr(0, found.find(' '));
}

bool isToldOf(const Body& biped, const std::string& reason) {
  const Limb* const arm = findLimb(biped, biped::leftArm);
  return arm != nullptr && std::ranges::find(arm->reasons, reason) != arm->reasons.end();
}

/// What alone tells the sides of an otherwise featureless body.
struct Sign {
  const char* says;
  void (*add)(SyntheticBiped&);
  const char* reason;
};

const Sign signs[] = {
    {"toes before the ankles",
     [](SyntheticBiped& body) {
       for (const std::string side : {".l", ".r"}) {
         const Vec3 ankle = jointOf(body, "foot" + side).position;
         body.joints.push_back({"toe" + side, "foot" + side, ankle + Vec3(0.0, -0.07, 0.13)});
       }
     },
     "sides: from the way the feet point"},
    {"an eye before the head",
     [](SyntheticBiped& body) {
       body.joints.push_back({"eye", "head", jointOf(body, "head").position + Vec3(0.0, 0.05, 0.08)});
       body.names["eye"] = "Eye";
     },
     "sides: from the way the feet point"},
    {"knees bent forward",
     [](SyntheticBiped& body) {
       for (const std::string side : {".l", ".r"}) {
         jointOf(body, "shin" + side).position.z = 0.1;
       }
     },
     "sides: from the way the feet point"},
    {"elbows bent back",
     [](SyntheticBiped& body) {
       for (const std::string side : {".l", ".r"}) {
         jointOf(body, "foreArm" + side).position.z = -0.12;
       }
     },
     "sides: from the way the feet point"},
    {"knees and elbows bent a little",
     [](SyntheticBiped& body) {
       for (const std::string side : {".l", ".r"}) {
         jointOf(body, "shin" + side).position.z = 0.01;
         jointOf(body, "foreArm" + side).position.z = -0.01;
       }
     },
     "sides: from the way that knees and elbows bend a little"},
};

} // namespace

TEST_CASE("Toes, an eye, knees or elbows alone tell left from right, whichever way the body faces") {
  for (const Sign& sign : signs) {
    for (const bool facesBackwards : {false, true}) {
      INFO(sign.says << (facesBackwards ? ", facing back" : ", facing front"));
      SyntheticBiped body = featureless();
      sign.add(body);
      body.facesBackwards = facesBackwards;
      const BuiltBiped built = build(body);
      const Body biped = detectBody(built.scene);
      CHECK(leftBase(built, biped) == "upperArm.l");
      CHECK(isToldOf(biped, sign.reason));
    }
  }
}

TEST_CASE("A body without any sign of its front is taken to face +Z, and says so") {
  SyntheticBiped body = featureless();
  body.facesBackwards = GENERATE(false, true);
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(leftBase(built, biped) == (body.facesBackwards ? "upperArm.r" : "upperArm.l"));
  CHECK(isToldOf(biped, "sides: taken to face +Z, as glTF characters do"));
}

TEST_CASE("Names tell the sides, and say whether the feet agree") {
  SyntheticBiped plain = featureless();
  applyNames(plain, namingScheme("Mixamo"));
  plain.facesBackwards = GENERATE(false, true);
  const BuiltBiped built = build(plain);
  const Body biped = detectBody(built.scene);
  CHECK(leftBase(built, biped) == "upperArm.l");
  CHECK(isToldOf(biped, "sides: from the joint names"));
  const Body withFeet = detectBody(build(makeNamedBody("Mixamo")).scene);
  CHECK(isToldOf(withFeet, "sides: names and feet agree"));
}

TEST_CASE("The less a body tells of its front, the less sure its limbs are") {
  const auto confidenceOf = [](const SyntheticBiped& body) {
    const Body biped = detectBody(build(body).scene);
    return findLimb(biped, biped::leftArm)->confidence;
  };
  SyntheticBiped toes = featureless();
  signs[0].add(toes);
  SyntheticBiped eye = featureless();
  signs[1].add(eye);
  CHECK(confidenceOf(eye) > confidenceOf(featureless()));
  SyntheticBiped both = toes;
  signs[1].add(both);
  CHECK(confidenceOf(both) >= confidenceOf(toes));
}

TEST_CASE("A foot that hangs elsewhere with its joint at the toes points where its mesh does from the shin") {
  SyntheticBiped body = makeNamedBody("Blender metarig");
  body.tubes = true;
  for (const std::string side : {".l", ".r"}) {
    const Vec3 toe = jointOf(body, "toe" + side).position;
    const Vec3 ankle = jointOf(body, "foot" + side).position;
    const Vec3 heel(toe.x, toe.y, ankle.z - 0.05);
    SyntheticJoint& foot = jointOf(body, "foot" + side);
    foot.parent = "root";
    foot.position = toe;
    foot.flesh = heel - toe;
    SyntheticJoint& shin = jointOf(body, "shin" + side);
    shin.flesh = ankle - shin.position;
    jointOf(body, "toe" + side).parent = "root";
    SyntheticJoint handle{"handle" + side, "foot" + side, heel};
    handle.movesMesh = false;
    body.joints.push_back(handle);
    body.names["handle" + side] = "ik_heel" + side;
  }
  body.facesBackwards = GENERATE(false, true);
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(leftBase(built, biped) == "upperArm.l");
  CHECK(isToldOf(biped, "sides: names and feet agree"));
  CHECK(describe(built, biped, biped::leftLeg) == "thigh.l shin.l -> foot.l");
}

// What is doubted of a body that was read, and what makes one a biped at all.
#include "rig/body/reading/doubts.h"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/body/reading/finding.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::rig::body;

namespace {

/// A body of rows of joints, the last of each its end, all of them bound where they stand and below no other.
struct DoubtedBody {
  Scene scene;
  BindPose bindPose;
  Body body;

  DoubtedBody() { body.isBiped = true; }

  Limb& add(const LimbPlace& place, const std::vector<std::string>& names, const std::vector<Vec3>& points) {
    Limb limb;
    static_cast<LimbPlace&>(limb) = place;
    for (std::size_t i = 0; i < points.size(); ++i) {
      limb.joints.push_back(test::addNode(scene, names[i], NodeIndex::none, points[i]));
      Mat4 world(1.0);
      world[3] = Vec4(points[i], 1.0);
      bindPose.worlds.push_back(world);
      limb.restLength += i == 0 ? 0.0 : glm::distance(points[i - 1], points[i]);
    }
    limb.endNode = limb.joints.back();
    limb.joints.pop_back();
    body.limbs.push_back(limb);
    return body.limbs.back();
  }

  Limb& addStraight(const LimbPlace& place, const std::vector<std::string>& names, const Vec3& from,
                    const Vec3& way) {
    return add(place, names, {from, from + 0.5 * way, from + way});
  }

  [[nodiscard]] PlanReading as(const char* plan) const {
    PlanReading reading;
    reading.plan = planNamed(plan);
    reading.limbs = body.limbs;
    return reading;
  }
};

const std::vector<std::string> threeBones{"Bone_x", "Joint_y", "Thing_z"};

/// Away from straight up by so many degrees.
Vec3 leaning(double degrees) {
  return {0.0, std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0)};
}

/// Arms and legs that go straight down by one, but the left arm, which goes down by this share of its length.
DoubtedBody standingOnFour(double leftArmDown) {
  DoubtedBody made;
  const Vec3 down(0.0, -1.0, 0.0);
  const Vec3 armWay(0.0, -leftArmDown, std::sqrt(1.0 - leftArmDown * leftArmDown));
  made.addStraight(biped::leftArm, threeBones, Vec3(0.1, 1.0, 0.5), armWay);
  made.addStraight(biped::rightArm, threeBones, Vec3(-0.1, 1.0, 0.5), down);
  made.addStraight(biped::leftLeg, threeBones, Vec3(0.1, 1.0, -0.5), down);
  made.addStraight(biped::rightLeg, threeBones, Vec3(-0.1, 1.0, -0.5), down);
  made.addStraight({LimbKind::tail}, threeBones, Vec3(0.0, 1.0, -0.6), down);
  return made;
}

Limb foundLimb(const LimbPlace& place, double confidence = 1.0) {
  Limb limb;
  static_cast<LimbPlace&>(limb) = place;
  limb.joints = {NodeIndex(0)};
  limb.confidence = confidence;
  return limb;
}

bool makeBiped(const std::vector<LimbPlace>& places, double confidence = 1.0) {
  std::vector<Limb> limbs;
  limbs.reserve(places.size());
  for (const LimbPlace& place : places) {
    limbs.push_back(foundLimb(place, confidence));
  }
  return makesBiped(limbs);
}

} // namespace

TEST_CASE("Both legs make a biped with both arms or with a spine, and both arms make one with a neck") {
  CHECK(makeBiped({biped::leftArm, biped::rightArm, biped::leftLeg, biped::rightLeg}));
  CHECK(makeBiped({biped::leftLeg, biped::rightLeg, biped::spine}));
  CHECK(makeBiped({biped::leftArm, biped::rightArm, biped::neck})); // in a robe
  CHECK_FALSE(makeBiped({biped::leftLeg, biped::rightLeg}));
  CHECK_FALSE(makeBiped({biped::leftLeg, biped::rightLeg, biped::leftArm}));
  CHECK_FALSE(makeBiped({biped::leftLeg, biped::rightLeg, biped::rightArm}));
  CHECK_FALSE(makeBiped({biped::leftLeg, biped::rightLeg, biped::neck}));
  CHECK_FALSE(makeBiped({biped::leftLeg, biped::spine}));
  CHECK_FALSE(makeBiped({biped::rightLeg, biped::spine}));
  CHECK_FALSE(makeBiped({biped::leftArm, biped::rightArm, biped::spine}));
  CHECK_FALSE(makeBiped({biped::leftArm, biped::neck}));
  CHECK(makeBiped({biped::leftLeg, biped::rightLeg, biped::spine}, 0.35));
  CHECK_FALSE(makeBiped({biped::leftLeg, biped::rightLeg, biped::spine}, 0.34));
}

TEST_CASE("A biped is better than a body that is none, else the body whose limbs are surer together") {
  const auto found = [](bool isBiped, const std::vector<double>& sure) {
    Finding finding;
    finding.result.isBiped = isBiped;
    for (const double confidence : sure) {
      finding.result.limbs.push_back(foundLimb(biped::spine, confidence));
    }
    return finding;
  };
  CHECK(isBetter(found(true, {0.4}), found(false, {0.9, 0.9})));
  CHECK_FALSE(isBetter(found(false, {0.9, 0.9}), found(true, {0.4})));
  for (const bool isBiped : {true, false}) {
    CHECK(isBetter(found(isBiped, {0.5, 0.5}), found(isBiped, {0.9})));
    CHECK_FALSE(isBetter(found(isBiped, {0.9}), found(isBiped, {0.5, 0.5})));
    CHECK_FALSE(isBetter(found(isBiped, {0.5}), found(isBiped, {0.5})));
  }
}

TEST_CASE("What is doubted is no surer than a guess, and told after what was told before") {
  Body body;
  body.planConfidence = 0.9;
  body.limbs = {foundLimb(biped::leftArm, 0.8), foundLimb(biped::rightArm, 0.3)};
  body.warnings = {"first"};
  doubt(body, "is it?");
  CHECK(body.planConfidence == 0.4);
  CHECK(body.limbs[0].confidence == 0.4);
  CHECK(body.limbs[1].confidence == 0.3);
  CHECK(body.warnings == std::vector<std::string>{"first", "is it?"});
}

TEST_CASE("A biped stands on four where its trunk lies and both arms and both legs go down") {
  const Vec3 lying = leaning(61.0);
  DoubtedBody made = standingOnFour(0.61);
  CHECK(standsOnFour(made.bindPose, made.body, 3.0 * lying));
  CHECK(standsOnFour(made.bindPose, made.body, -lying)); // the head hangs
  CHECK_FALSE(standsOnFour(made.bindPose, made.body, 3.0 * leaning(59.0)));
  CHECK_FALSE(standsOnFour(made.bindPose, made.body, -leaning(59.0)));
  const DoubtedBody pointing = standingOnFour(0.59);
  CHECK_FALSE(standsOnFour(pointing.bindPose, pointing.body, lying));
  made.body.isBiped = false;
  CHECK_FALSE(standsOnFour(made.bindPose, made.body, lying));
}

TEST_CASE("Arms of which more joints are called legs than arms are legs, where they are long enough") {
  const auto doubted = [](const std::vector<std::string>& names, double armLength, bool isBiped = true) {
    DoubtedBody made;
    const Vec3 down(0.0, -1.0, 0.0);
    made.addStraight(biped::leftArm, names, Vec3(0.1, 1.0, 0.5), armLength * down);
    made.addStraight(biped::rightArm, threeBones, Vec3(-0.1, 1.0, 0.5), 0.2 * down);
    made.addStraight(biped::leftLeg, {"hand_1", "elbow_2", "arm_3"}, Vec3(0.1, 1.0, -0.5), down);
    made.addStraight(biped::rightLeg, threeBones, Vec3(-0.1, 1.0, -0.5), 0.5 * down);
    made.body.isBiped = isBiped;
    return hasLegsForArms(made.scene, made.body);
  };
  CHECK(doubted({"hoof_1", "Joint_y", "hock_2"}, 0.71));
  CHECK_FALSE(doubted({"hoof_1", "Joint_y", "hock_2"}, 0.69));
  CHECK_FALSE(doubted({"hoof_1", "Joint_y", "hock_2"}, 0.71, false));
  CHECK_FALSE(doubted({"hoof_1", "Joint_y", "Thing_z"}, 0.71));
  CHECK(doubted({"hoof_1", "elbow_1", "hock_2"}, 0.71));
  CHECK_FALSE(doubted({"hand_1", "elbow_1", "hock_2"}, 0.71));
}

TEST_CASE("A biped leans as a bird does where its spine is more than 60 degrees off its legs") {
  const Vec3 legsReach(0.0, -2.0, 0.0);
  const auto leans = [&](double degrees) {
    DoubtedBody made;
    made.addStraight(biped::spine, threeBones, Vec3(0.0, 1.0, 0.0), 0.4 * leaning(degrees));
    return leansAsABird(made.bindPose, made.body, legsReach);
  };
  CHECK_FALSE(leans(0.0));
  CHECK_FALSE(leans(59.0));
  CHECK(leans(61.0));
  CHECK(leans(180.0));
  DoubtedBody made;
  CHECK_FALSE(leansAsABird(made.bindPose, made.body, legsReach));
  made.addStraight(biped::spine, threeBones, Vec3(0.0, 1.0, 0.0), leaning(90.0));
  made.body.isBiped = false;
  CHECK_FALSE(leansAsABird(made.bindPose, made.body, legsReach));
}

TEST_CASE("What stands on two legs that names call arms is doubted, a beast on four and its arms are not") {
  const auto doubted = [](const char* plan, const char* joint, const LimbPlace& place) {
    DoubtedBody made;
    made.addStraight(place, {"Bone_x", joint, "Thing_z"}, Vec3(0.1, 1.0, 0.0), Vec3(0.0, -1.0, 0.0));
    return hasArmsForLegs(made.scene, made.as(plan));
  };
  CHECK(doubted("bird", "UpperArm.L", biped::leftLeg));
  CHECK_FALSE(doubted("bird", "Joint_y", biped::leftLeg));
  CHECK_FALSE(doubted("bird", "UpperArm.L", biped::leftArm));
  CHECK_FALSE(doubted("quadruped", "UpperArm.L", biped::leftLeg));
  CHECK(doubted("insect", "UpperArm.L", biped::leftLeg));
  CHECK(doubted("insect", "arm_2_l", biped::leftLeg)); // a centaur's, of whatever joint
  CHECK_FALSE(doubted("insect", "Joint_y", biped::leftLeg));
}

TEST_CASE(
    "A biped without arms whose joints are called wings is doubted, one with arms and a beast are not") {
  const auto doubted = [](const char* joint, const LimbPlace& place, bool isBiped = true) {
    DoubtedBody made;
    made.addStraight(place, {"Bone_x", joint, "Thing_z"}, Vec3(0.1, 1.0, 0.0), Vec3(0.0, -1.0, 0.0));
    made.body.isBiped = isBiped;
    return hasWingsForArms(made.scene, made.body);
  };
  CHECK(doubted("wing_2", biped::leftLeg));
  CHECK_FALSE(doubted("Joint_y", biped::leftLeg));
  CHECK_FALSE(doubted("wing_2", biped::leftArm));
  CHECK_FALSE(doubted("wing_2", biped::leftLeg, false));
}

TEST_CASE("Wings and arms of a body are guessed where its plan is hardly sure, legs are not") {
  const auto guessed = [](const LimbPlace& place, double confidence) {
    DoubtedBody made;
    made.addStraight(place, threeBones, Vec3(0.1, 1.0, 0.0), Vec3(0.0, -1.0, 0.0));
    PlanReading reading = made.as("quadruped");
    reading.confidence = confidence;
    return hasGuessedWings(reading);
  };
  CHECK(guessed({LimbKind::wing, LimbSide::left}, 0.79));
  CHECK(guessed(biped::leftArm, 0.79));
  CHECK_FALSE(guessed(biped::leftLeg, 0.79));
  CHECK_FALSE(guessed(biped::leftArm, 0.81));
}

TEST_CASE("A bird with upper arms may be a person, but for one with a tail that is called so or long") {
  const auto mayBe = [](const char* plan, const char* upperArm, const char* tailJoint, double tailLength) {
    DoubtedBody made;
    const Vec3 out(1.0, 0.0, 0.0);
    made.addStraight(biped::leftArm, {upperArm, "Joint_y", "Thing_z"}, Vec3(0.1, 1.0, 0.0), 0.8 * out);
    made.addStraight(biped::rightArm, threeBones, Vec3(-0.1, 1.0, 0.0), -0.5 * out);
    if (tailLength > 0.0) {
      made.addStraight({LimbKind::tail}, {"Joint_u", tailJoint, "Thing_w"}, Vec3(0.0), tailLength * out);
    }
    return mayBePerson(made.scene, made.as(plan));
  };
  CHECK(mayBe("bird", "upperarm_l", "", 0.0));
  CHECK(mayBe("bird", "upperarm_l", "Joint_v", 0.79));
  CHECK_FALSE(mayBe("bird", "upperarm_l", "Joint_v", 0.81));
  CHECK_FALSE(mayBe("bird", "upperarm_l", "tail_1", 0.3));
  CHECK_FALSE(mayBe("bird", "wing_l", "", 0.0));
  CHECK_FALSE(mayBe("quadruped", "upperarm_l", "", 0.0));
}

TEST_CASE(
    "A bird may be a person where its wings are called upper arms, and not where they are called wings too") {
  for (const auto& [name, may] :
       {std::pair("upperarm_l", true), {"wing_upperarm_l", false}, {"Bone_x", false}}) {
    CAPTURE(name);
    DoubtedBody made;
    made.addStraight({LimbKind::wing, LimbSide::left}, {name, "Joint_y", "Thing_z"}, Vec3(0.1, 1.0, 0.0),
                     Vec3(0.8, 0.0, 0.0));
    CHECK(mayBePerson(made.scene, made.as("bird")) == may);
  }
}

TEST_CASE(
    "What goes along a joint of an arm in the middle of a body is that arm, along one of a leg it is not") {
  const LimbKind kind = GENERATE(LimbKind::tail, LimbKind::neck, LimbKind::spine);
  const Vec3 out(1.0, 0.0, 0.0);
  DoubtedBody made;
  const std::vector<NodeIndex> arm = made.addStraight(biped::rightArm, threeBones, Vec3(0.0), out).joints;
  const std::vector<NodeIndex> leg = made.addStraight(biped::rightLeg, threeBones, Vec3(0.0), out).joints;
  const std::vector<Limb> person = made.body.limbs;
  const auto isArm = [&](const std::vector<NodeIndex>& joints) {
    PlanReading reading = made.as("bird");
    reading.limbs.front().kind = kind;
    reading.limbs.front().side = LimbSide::middle;
    reading.limbs.front().joints = joints;
    return hasArmInMiddle(reading, person);
  };
  CHECK(isArm({NodeIndex(90), arm.back(), NodeIndex(91)}));
  CHECK_FALSE(isArm({NodeIndex(90), leg.back(), NodeIndex(91)}));
  CHECK_FALSE(isArm({NodeIndex(90), NodeIndex(91)}));
  CHECK_FALSE(hasArmInMiddle(made.as("bird"), person)); // nothing in the middle
}

TEST_CASE("A row of joints may be no serpent where it stands or is little of the body, and no name tells") {
  const auto mayBeNone = [](const Vec3& way, std::size_t joints, const char* name = "Thing_z",
                            const char* plan = "serpent") {
    DoubtedBody made;
    made.addStraight(biped::spine, {"Bone_x", "Joint_y", name}, Vec3(0.0), way);
    made.scene.skins.emplace_back();
    for (std::size_t i = 0; i < joints; ++i) {
      made.scene.skins.front().joints.emplace_back(i);
      if (i >= made.scene.nodes.size()) {
        test::addNode(made.scene, "Lump_" + std::string(i, 'o'), NodeIndex::none, Vec3(0.0));
      }
    }
    return mayBeNoSerpent(made.scene, made.bindPose, made.as(plan));
  };
  const Vec3 lying(0.0, 0.0, 2.0);
  CHECK_FALSE(mayBeNone(lying, 3));
  CHECK_FALSE(mayBeNone(lying, 4)); // Two joints and their end are at least half of four.
  CHECK(mayBeNone(lying, 5));
  CHECK(mayBeNone(2.0 * leaning(45.0), 3));
  CHECK(mayBeNone(-2.0 * leaning(45.0), 3));
  CHECK_FALSE(mayBeNone(2.0 * leaning(46.0), 3));
  for (const char* const name : {"tail_1", "fin_1"}) {
    CAPTURE(name);
    CHECK_FALSE(mayBeNone(leaning(0.0), 5, name));
  }
  // Many things have a head: it tells of one that lies that the row is the body.
  CHECK_FALSE(mayBeNone(lying, 5, "head_1"));
  CHECK(mayBeNone(leaning(0.0), 3, "head_1"));
  for (const char* const name : {"leg_1", "Arm_L", "wing_2", "antler_1"}) {
    CAPTURE(name);
    CHECK(mayBeNone(lying, 3, name));
  }
  CHECK_FALSE(mayBeNone(leaning(0.0), 5, "Thing_z", "bird"));
  const DoubtedBody rowless;
  CHECK_FALSE(mayBeNoSerpent(rowless.scene, rowless.bindPose, rowless.as("serpent")));
}

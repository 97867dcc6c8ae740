#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "skinning/locate/arm_joints.h"
#include "skinning/locate/fit_biped.h"
#include "skinning/locate/trunk_joints.h"
#include "tests/support/skinning/tube_person.h"

using namespace stretch;
using namespace stretch::skinning;
using test::TubePerson;
using test::tubePerson;
using test::TubePose;

namespace {

constexpr double height = 1.8;
constexpr double goal = 0.05; // of the height

using Move = std::function<Vec3(const Vec3&)>;

std::vector<Vec3> moved(const std::vector<Vec3>& positions, const Move& move) {
  std::vector<Vec3> all(positions.size());
  std::ranges::transform(positions, all.begin(), move);
  return all;
}

const FittedJoint& jointOf(const FittedBiped& fitted, const std::string& name) {
  for (const FittedJoint& joint : fitted.joints) {
    if (joint.name == name) {
      return joint;
    }
  }
  throw std::runtime_error("no joint " + name);
}

Vec3 asMade(const Vec3& position) {
  return position;
}

// Each joint that the person was made with, moved as its mesh is, within the goal.
void checkFits(const TubePerson& person, const Move& move = asMade, double unit = 1.0, double within = goal) {
  const Result<FittedBiped> fitted = fitBiped(moved(person.positions, move), person.triangles);
  REQUIRE(fitted);
  CHECK(fitted->joints.size() == 22);
  CHECK(fitted->warnings.empty());
  for (const auto& [name, place] : person.joints) {
    const FittedJoint& joint = jointOf(*fitted, name);
    INFO(name << " is off by " << 100.0 * glm::distance(joint.position, move(place)) / (unit * height)
              << " % of the height");
    CHECK(glm::distance(joint.position, move(place)) < within * unit * height);
    CHECK(joint.confidence >= 0.5);
  }
}

std::string problemOf(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  const Result<FittedBiped> fitted = fitBiped(positions, triangles);
  return fitted ? std::string() : fitted.error().line();
}

} // namespace

TEST_CASE("Joints are found in a person with the arms sideways, half down and hanging", "[locators]") {
  for (const double degrees : {0.0, 45.0, 75.0}) {
    INFO("arms " << degrees << " degrees down");
    checkFits(tubePerson({.armsDown = degrees * pi / 180.0, .shoulders = degrees > 60.0 ? 0.24 : 0.2}));
  }
}

TEST_CASE("Joints are found in a mesh with a hole in every seventh triangle", "[locators]") {
  checkFits(tubePerson({.everyNthHole = 7}));
}

TEST_CASE("A person may stand anywhere, face anywhere, lie, stand on the head, in any units", "[locators]") {
  const TubePerson person = tubePerson({.armsDown = 0.5});
  const auto turned = [](const Vec3& axis, double degrees) {
    const Quat turn = axisAngle(axis, degrees * pi / 180.0);
    return [turn](const Vec3& p) { return turn * p + Vec3(3.0, -1.0, 7.0); };
  };
  checkFits(person, turned({0.0, 1.0, 0.0}, 180.0));
  checkFits(person, turned({0.0, 1.0, 0.0}, 37.0));
  checkFits(person, turned({1.0, 0.0, 0.0}, 90.0));
  checkFits(person, turned({1.0, 0.0, 0.0}, -90.0));
  checkFits(person, turned({0.0, 0.0, 1.0}, 90.0));
  checkFits(person, turned({0.0, 0.0, 1.0}, 180.0));
  for (const double unit : {1e-4, 1e5}) {
    checkFits(
        person, [unit](const Vec3& p) { return unit * p; }, unit);
  }
}

TEST_CASE("Limbs that are boxes turn where they begin and in their middles", "[locators]") {
  const TubePerson person = test::blockPerson();
  const Result<FittedBiped> fitted = fitBiped(person.positions, person.triangles);
  REQUIRE(fitted);
  for (const auto& [name, place] : person.joints) {
    const Vec3& found = jointOf(*fitted, name).position;
    INFO(name);
    // Without feet it may face either way: left may be right.
    const Vec3 either(found.x * place.x < 0.0 ? -found.x : found.x, found.y, found.z);
    CHECK(glm::distance(either, place) < 0.02 * height);
  }
  for (const char* hand : {"leftHand", "rightHand"}) {
    CHECK(jointOf(*fitted, hand).confidence < 0.5); // a box shows no wrist
  }
}

TEST_CASE("Hips are over the crotch, but not where that lies between the bones of a pelvis", "[locators]") {
  CHECK(hipHeightOf(0.16, 0.5) == Approx(0.19));
  CHECK(hipHeightOf(0.47, 0.82) == Approx(0.496).margin(0.01));
  CHECK(hipHeightOf(0.54, 0.8) < 0.5);
}

TEST_CASE("An elbow is where a thin rod meets a thick forearm", "[locators]") {
  const TubePerson robot = tubePerson({.hasRods = true});
  checkFits(robot, asMade, 1.0, 0.04);
  const Result<FittedBiped> fitted = fitBiped(robot.positions, robot.triangles);
  REQUIRE(fitted);
  for (const std::string side : {"left", "right"}) {
    const Vec3& elbow = jointOf(*fitted, side + "LowerArm").position;
    CHECK(glm::distance(elbow, robot.joints.at(side + "LowerArm")) < 0.015); // in the forearm, not at its end
  }
}

TEST_CASE("A beard does not draw the head's joint forward", "[locators]") {
  TubePerson person = tubePerson();
  const auto first = static_cast<std::uint32_t>(person.positions.size());
  for (std::uint32_t corner = 0; corner < 8; ++corner) { // a box before the neck and the chin
    person.positions.emplace_back((corner & 1U) != 0 ? 0.06 : -0.06, (corner & 2U) != 0 ? 1.6 : 1.5,
                                  (corner & 4U) != 0 ? 0.25 : 0.0);
  }
  for (const Triangle& side : std::vector<Triangle>{{0, 1, 3},
                                                    {0, 3, 2},
                                                    {4, 5, 7},
                                                    {4, 7, 6},
                                                    {0, 1, 5},
                                                    {0, 5, 4},
                                                    {2, 3, 7},
                                                    {2, 7, 6},
                                                    {0, 2, 6},
                                                    {0, 6, 4},
                                                    {1, 3, 7},
                                                    {1, 7, 5}}) {
    person.triangles.push_back({side[0] + first, side[1] + first, side[2] + first});
  }
  const Result<FittedBiped> fitted = fitBiped(person.positions, person.triangles);
  REQUIRE(fitted);
  const Vec3 way = jointOf(*fitted, "head").position - jointOf(*fitted, "neck").position;
  CHECK(std::abs(way.z) < way.y);
}

TEST_CASE("What one hand holds does not make its arm longer", "[locators]") {
  checkFits(tubePerson({.holdsInRight = 0.4}));
  checkFits(tubePerson({.holdsInLeft = 0.4}));
}

TEST_CASE("An arm that is guessed from the other one lies as that one does on the other side, half as sure",
          "[locators]") {
  const ArmJoints left{{Vec3(0.2, 0.8, 0.01), 0.8}, {Vec3(0.3, 0.6, -0.02), 0.7}, {Vec3(0.4, 0.5, 0.1), 0.6}};
  const ArmJoints right = mirroredArm(left);
  const Vec3 across(-1.0, 1.0, 1.0);
  for (const auto& [mirrored, own] :
       {std::pair(right.shoulder, left.shoulder), std::pair(right.elbow, left.elbow),
        std::pair(right.wrist, left.wrist)}) {
    CHECK(mirrored.place == across * own.place);
    CHECK(mirrored.confidence == Approx(0.5 * own.confidence));
  }
}

TEST_CASE("Arms that do not show are guessed, unsure, and named for setting them by hand", "[locators]") {
  const TubePerson person = tubePerson({.hasArms = false});
  const Result<FittedBiped> fitted = fitBiped(person.positions, person.triangles);
  REQUIRE(fitted);
  REQUIRE(fitted->warnings.size() == 1);
  CHECK(fitted->warnings[0].find("UpperArm, LowerArm and Hand") != std::string::npos);
  CHECK(jointOf(*fitted, "leftHand").confidence < 0.5);
  CHECK(jointOf(*fitted, "leftLowerLeg").confidence >= 0.5);
  CHECK(glm::distance(jointOf(*fitted, "leftFoot").position, person.joints.at("leftFoot")) < goal * height);
}

TEST_CASE("A body on four legs gets joints that are no more than a guess, and is told", "[locators]") {
  TubePerson centaur = tubePerson();
  const auto first = static_cast<std::uint32_t>(centaur.positions.size());
  for (const Vec3& position :
       moved(centaur.positions, [](const Vec3& p) { return p - Vec3(0.0, 0.0, 0.6); })) {
    centaur.positions.push_back(position);
  }
  for (const Triangle& triangle : std::vector<Triangle>(centaur.triangles)) {
    centaur.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  }
  const Result<FittedBiped> fitted = fitBiped(centaur.positions, centaur.triangles);
  REQUIRE(fitted);
  REQUIRE(fitted->warnings.size() == 1);
  CHECK(fitted->warnings[0].find("it stands on 4 legs") != std::string::npos);
  CHECK(jointOf(*fitted, "leftHand").confidence < 0.5);
}

TEST_CASE("A body with as many limbs as a spider is told to be no biped, whichever way it seems to stand",
          "[locators]") {
  TubePerson creature = tubePerson();
  const auto first = static_cast<std::uint32_t>(creature.positions.size());
  // A second one, upside down on its shoulders: four hands and four feet.
  for (const Vec3& position :
       moved(creature.positions, [](const Vec3& p) { return Vec3(-p.x, 3.2 - p.y, p.z); })) {
    creature.positions.push_back(position);
  }
  for (const Triangle& triangle : std::vector<Triangle>(creature.triangles)) {
    creature.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  }
  const Result<FittedBiped> fitted = fitBiped(creature.positions, creature.triangles);
  REQUIRE(fitted);
  REQUIRE_FALSE(fitted->warnings.empty());
  CHECK(fitted->warnings.back().find("8 limbs or tips") != std::string::npos);
  CHECK(jointOf(*fitted, "leftHand").confidence < 0.5);
  CHECK(fitBiped(tubePerson().positions, tubePerson().triangles)->warnings.empty());
}

TEST_CASE("A body whose trunk lies on its two legs is told to be no biped", "[locators]") {
  TubePerson bird = tubePerson();
  constexpr double hips = 0.92;
  bird.positions = moved(bird.positions, [](const Vec3& p) {
    return p.y > hips ? Vec3(p.x, hips - p.z, p.y - hips) : p; // bent forward at the hips
  });
  const Result<FittedBiped> fitted = fitBiped(bird.positions, bird.triangles);
  REQUIRE(fitted);
  REQUIRE_FALSE(fitted->warnings.empty());
  CHECK(fitted->warnings.back().find("its trunk lies") != std::string::npos);
  CHECK(jointOf(*fitted, "leftFoot").confidence < 0.5);
}

TEST_CASE("What is no body is refused in one line that says what to do", "[locators]") {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> plane{{0, 1, 2}, {0, 2, 3}};
  const std::vector<Triangle> pyramid{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const std::vector<Triangle> one{{0, 1, 2}};
  const std::vector<Triangle> none;
  for (const std::vector<Triangle>& triangles : {none, one, plane, pyramid}) {
    const std::string line = problemOf(corners, triangles);
    INFO(line);
    CHECK(line.find("by hand") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
  CHECK_FALSE(problemOf({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}).empty());
  CHECK_FALSE(problemOf({{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).empty());
}

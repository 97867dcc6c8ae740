#include <fstream>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/math/rotation.h"
#include "rig/ik/spline_spine.h"
#include "rig/ik/two_bone.h"

namespace {

using namespace stretch;
using namespace stretch::rig;

Vec3 pointOf(const nlohmann::json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

std::vector<Vec3> pointsOf(const nlohmann::json& json) {
  std::vector<Vec3> points;
  for (const auto& point : json) {
    points.push_back(pointOf(point));
  }
  return points;
}

nlohmann::json workedControllers(const char* which) {
  std::ifstream file(STRETCH_SOURCE_DIR "/tests/rig/ik/controllers_vectors.json");
  REQUIRE(file.good());
  return nlohmann::json::parse(file)[which];
}

TwoBoneProblem twoBoneOf(const nlohmann::json& json) {
  TwoBoneProblem problem;
  problem.base = pointOf(json["base"]);
  problem.joint = pointOf(json["joint"]);
  problem.end = pointOf(json["end"]);
  problem.target = pointOf(json["target"]);
  problem.poleOffset = pointOf(json["pole"]);
  problem.stretchSwitch = json["stretch"].get<double>();
  return problem;
}

SplineSpineProblem spineOf(const nlohmann::json& json, double stretchSwitch) {
  SplineSpineProblem problem;
  problem.points = pointsOf(json["joints"]);
  problem.along = json["u"].get<std::vector<double>>();
  problem.low = pointOf(json["low"]);
  problem.middle = pointOf(json["mid"]);
  problem.top = pointOf(json["top"]);
  problem.stretchSwitch = stretchSwitch;
  return problem;
}

double farthestApart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  REQUIRE(a.size() == b.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    farthest = std::max(farthest, glm::length(a[i] - b[i]));
  }
  return farthest;
}

// A leg that stands: hip, knee a little in front, ankle.
TwoBoneProblem standingLeg() {
  TwoBoneProblem leg;
  leg.base = {0.1, 0.9, 0.0};
  leg.joint = {0.1, 0.5, 0.05};
  leg.end = {0.1, 0.1, 0.0};
  leg.target = leg.end;
  return leg;
}

} // namespace

TEST_CASE("a limb reaches softly for a far target as the worked cases say") {
  for (const auto& one : workedControllers("soft_reach")) {
    INFO(one.dump());
    CHECK(std::abs(softReach(one["L"].get<double>(), one["d0"].get<double>(), one["d"].get<double>(),
                             one.value("softness", 0.0)) -
                   one["e"].get<double>()) < 1e-6);
  }
}

TEST_CASE("two bones come to the places of the worked cases") {
  for (const auto& one : workedControllers("limb")) {
    INFO(one.dump());
    const TwoBoneProblem problem = twoBoneOf(one);
    const TwoBoneShape shape = solveTwoBone(problem);
    CHECK(glm::length(shape.joint - pointOf(one["joint_new"])) < 1e-6);
    CHECK(glm::length(shape.end - pointOf(one["end_new"])) < 1e-6);
    CHECK(std::abs(shape.scale - one["bone_scale"].get<double>()) < 1e-6);
    const Vec3 first = shape.turns[0] * (problem.joint - problem.base) * shape.scale;
    const Vec3 second = shape.turns[1] * (problem.end - problem.joint) * shape.scale;
    CHECK(glm::length(problem.base + first - shape.joint) < 1e-9);
    CHECK(glm::length(shape.joint + second - shape.end) < 1e-9);
  }
}

TEST_CASE("a spine comes to the places of the worked cases, stretched and laid") {
  for (const auto& one : workedControllers("spine")) {
    INFO(one.dump());
    CHECK(farthestApart(solveSplineSpine(spineOf(one, 1.0)).points, pointsOf(one["joints_new"])) < 1e-6);
    CHECK(farthestApart(solveSplineSpine(spineOf(one, 0.0)).points, pointsOf(one["laid"])) < 1e-6);
    CHECK(farthestApart(solveSplineSpine(spineOf(one, 0.0)).wanted, pointsOf(one["joints_new"])) < 1e-6);
  }
}

TEST_CASE("a limb whose controls have not moved is left exactly as it is") {
  const TwoBoneShape shape = solveTwoBone(standingLeg());
  const Quat none(1.0, 0.0, 0.0, 0.0);
  CHECK(shape.turns[0] == none);
  CHECK(shape.turns[1] == none);
  CHECK(shape.scale == 1.0);
  CHECK(shape.end == standingLeg().end);
}

TEST_CASE("a knee is turned out by its pole while the foot stays") {
  TwoBoneProblem leg = standingLeg();
  leg.poleOffset = {0.6, 0.0, 0.0};
  const TwoBoneShape shape = solveTwoBone(leg);
  CHECK(glm::length(shape.end - leg.end) < 1e-12);
  CHECK(shape.joint.x > leg.joint.x + 0.02);
  CHECK(shape.scale == 1.0);
}

TEST_CASE("a pole far behind a limb leads its joint there, and one on its line changes nothing") {
  TwoBoneProblem leg = standingLeg();
  leg.poleOffset = {0.0, 0.0, -1.0};
  CHECK(solveTwoBone(leg).joint.z < -0.04);
  leg.poleOffset = Vec3(leg.base.x, 0.4, 0.0) - polePlace(standingLeg());
  CHECK(glm::length(solveTwoBone(leg).joint - leg.joint) < 1e-6);
}

TEST_CASE("a straight leg that is pressed down bends its knee the usual way") {
  TwoBoneProblem leg = standingLeg();
  leg.joint.z = -1e-5; // a hair beyond straight
  leg.usualBend = {0.0, 0.0, 1.0};
  leg.target.y = 0.3;
  CHECK(solveTwoBone(leg).joint.z > 0.1);
  leg.target.y = leg.end.y + 1e-7;
  CHECK(glm::length(solveTwoBone(leg).joint - leg.joint) < 1e-3);
}

TEST_CASE(
    "an overextended leg that is pressed down bends its knee the usual way, one that bends back goes on") {
  TwoBoneProblem leg = standingLeg();
  leg.usualBend = {0.0, 0.0, 1.0};
  leg.target.y = 0.3;
  leg.joint.z = -0.03;
  CHECK(solveTwoBone(leg).joint.z > 0.1);
  leg.joint.z = -0.4;
  CHECK(solveTwoBone(leg).joint.z < -0.1);
  leg.joint.z = -0.03;
  leg.target = leg.end;
  CHECK(solveTwoBone(leg).joint == leg.joint);
}

TEST_CASE("a limb without length is told, and stays finite") {
  TwoBoneProblem leg = standingLeg();
  leg.joint = leg.base;
  CHECK(solveTwoBone(leg).outcome == ShapeOutcome::degenerate);
  leg = standingLeg();
  leg.target = leg.base;
  CHECK(solveTwoBone(leg).outcome == ShapeOutcome::clamped);
  leg.target = leg.base + Vec3(0.0, 1e9, 0.0);
  const TwoBoneShape far = solveTwoBone(leg);
  CHECK(far.outcome == ShapeOutcome::clamped);
  CHECK(std::isfinite(far.end.y));
}

TEST_CASE("a spine twists towards its top, and more than half a turn is not taken back") {
  SplineSpineProblem spine;
  spine.points = {{0, 1, 0}, {0, 1.2, 0}, {0, 1.4, 0}};
  spine.along = {0.0, 0.5, 1.0};
  spine.turn = {0.0, 1.5 * pi, 0.0};
  const SplineSpineShape shape = solveSplineSpine(spine);
  const Vec3 side(1.0, 0.0, 0.0);
  CHECK(glm::length(shape.turns[0] * side - axisAngle({0, 1, 0}, 0.375 * pi) * side) < 1e-9);
  CHECK(glm::length(shape.turns[1] * side - axisAngle({0, 1, 0}, 1.125 * pi) * side) < 1e-9);
  CHECK(glm::length(shape.topTurn * side - axisAngle({0, 1, 0}, 1.5 * pi) * side) < 1e-9);
}

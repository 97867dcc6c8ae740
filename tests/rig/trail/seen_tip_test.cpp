#include <cmath>
#include <fstream>
#include <limits>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "rig/trail/exaggeration.h"
#include "rig/trail/seen_tip.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

Vec3 pointIn(const nlohmann::json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

SeenProblem seenProblemOf(const nlohmann::json& json) {
  const nlohmann::json& camera = json["camera"];
  SeenProblem problem;
  problem.camera = {camera["kind"] == "perspective" ? CameraKind::perspective : CameraKind::orthographic,
                    pointIn(camera["position"]), pointIn(camera["right"]), pointIn(camera["up"]),
                    pointIn(camera["forward"])};
  problem.base = pointIn(json["base"]);
  problem.tip = pointIn(json["tip"]);
  problem.direction = pointIn(json["direction"]);
  problem.pivotDistance = json["pivot_distance"].get<double>();
  problem.scale = json["scale"].get<double>();
  problem.keepDepth = json["keep_depth"].get<bool>();
  return problem;
}

// An arm along +X, one unit long, whose path goes on along it, seen from +Z.
SeenProblem acrossTheView(CameraKind kind, double scale) {
  SeenProblem problem;
  problem.camera = {kind, Vec3(0.0, 0.0, 5.0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)};
  problem.tip = Vec3(1.0, 0.0, 0.0);
  problem.direction = Vec3(1.0, 0.0, 0.0);
  problem.pivotDistance = 2.0;
  problem.scale = scale;
  return problem;
}

// A path along the arm, three samples, base at the origin.
TipProblem pathAlong(const Vec3& direction, double scale) {
  TipProblem problem;
  problem.points = {0.5 * direction, 0.75 * direction, direction};
  problem.limbLength = glm::length(direction);
  problem.scale = scale;
  return problem;
}

} // namespace

TEST_CASE("as the camera sees it: the specification's worked cases come out to 1e-6") {
  std::ifstream file(STRETCH_SOURCE_DIR "/tests/rig/trail/seen_tip_vectors.json");
  REQUIRE(file.good());
  const nlohmann::json cases = nlohmann::json::parse(file)["cases"];
  REQUIRE(cases.size() == 60);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    CAPTURE(i);
    const SeenTip solved = solveSeenTip(seenProblemOf(cases[i]));
    CHECK(glm::length(solved.tip - pointIn(cases[i]["new_tip"])) < 1e-6);
    CHECK(solved.walk == Approx(cases[i]["walk"].get<double>()).margin(1e-6));
    CHECK(solved.seen == Approx(cases[i]["seen"].get<double>()).margin(1e-6));
    CHECK(solved.reached == cases[i]["reached"].get<bool>());
  }
}

TEST_CASE(
    "a limb across the view looks as long as it is: seen three times as long it is three times as long") {
  for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
    const SeenTip solved = solveSeenTip(acrossTheView(kind, 3.0));
    CHECK(glm::length(solved.tip - Vec3(3.0, 0.0, 0.0)) < 1e-12);
    CHECK(solved.reached);
    const SeenTip shorter = solveSeenTip(acrossTheView(kind, 0.25));
    CHECK(glm::length(shorter.tip - Vec3(0.25, 0.0, 0.0)) < 1e-12);
    CHECK(shorter.walk == Approx(-0.75));
    CHECK(solveSeenTip(acrossTheView(kind, 1.0)).tip == Vec3(1.0, 0.0, 0.0));
  }
}

TEST_CASE("no tip gets farther from the base than five times its length, and the longest look is told") {
  const SeenTip solved = solveSeenTip(acrossTheView(CameraKind::orthographic, 7.0));
  CHECK_FALSE(solved.reached);
  CHECK(solved.seen == Approx(5.0));
  CHECK(glm::length(solved.tip) == Approx(5.0));
}

TEST_CASE("the farthest tip, one at its pivot and the nearest look are reached, each at its edge") {
  const SeenTip farthest = solveSeenTip(acrossTheView(CameraKind::orthographic, farthestSeen));
  CHECK(farthest.reached);
  CHECK(farthest.walk == 4.0);
  SeenProblem problem = acrossTheView(CameraKind::orthographic, 0.5);
  problem.pivotDistance = 0.5;
  CHECK(solveSeenTip(problem).reached);
  problem.scale = 0.8; // of 5: as near as the line comes to the base
  problem.tip = Vec3(3.0, 4.0, 0.0);
  problem.pivotDistance = 6.0;
  const SeenTip nearest = solveSeenTip(problem);
  CHECK(nearest.reached);
  CHECK(nearest.tip == Vec3(0.0, 4.0, 0.0));
}

TEST_CASE("inwards the walk ends at the pivot") {
  SeenProblem problem = acrossTheView(CameraKind::orthographic, 0.1);
  problem.pivotDistance = 0.5;
  const SeenTip solved = solveSeenTip(problem);
  CHECK_FALSE(solved.reached);
  CHECK(solved.walk == Approx(-0.5));
  CHECK(solved.seen == Approx(0.5));
}

TEST_CASE(
    "a path that points at the camera grows along the limb's own way in the picture, and keeps its depth") {
  SeenProblem problem = acrossTheView(CameraKind::perspective, 2.0);
  problem.direction = glm::normalize(Vec3(0.0, 0.05, 1.0));
  const SeenTip solved = solveSeenTip(problem);
  CHECK(solved.alongLimb);
  CHECK(glm::length(solved.tip - Vec3(2.0, 0.0, 0.0)) < 1e-12);
  problem.direction = glm::normalize(Vec3(0.0, 0.2, 1.0)); // enough of it is seen
  const SeenTip along = solveSeenTip(problem);
  CHECK_FALSE(along.alongLimb);
  CHECK(along.tip.z == Approx(0.0).margin(1e-12));
  CHECK(along.tip.x == Approx(1.0));
  problem.keepDepth = false;
  const SeenTip deep = solveSeenTip(problem);
  CHECK(deep.reached);
  CHECK(deep.tip.z > 0.5);
  CHECK(deep.seen == Approx(2.0));
}

TEST_CASE("a limb that the camera does not see stays, and is told as not reached") {
  SeenProblem behind = acrossTheView(CameraKind::perspective, 2.0);
  behind.camera.position.z = -5.0;
  SeenProblem towards = acrossTheView(CameraKind::orthographic, 2.0);
  towards.tip = Vec3(0.0, 0.0, 1.0);
  SeenProblem nowhere = acrossTheView(CameraKind::perspective, 2.0);
  nowhere.base.x = std::numeric_limits<double>::quiet_NaN();
  for (const SeenProblem& problem : {behind, towards, nowhere}) {
    const SeenTip solved = solveSeenTip(problem);
    CHECK_FALSE(solved.reached);
    CHECK(solved.tip == problem.tip);
    CHECK(solved.walk == 0.0);
  }
}

TEST_CASE("a walk towards a perspective camera ends in front of it") {
  SeenProblem problem = acrossTheView(CameraKind::perspective, 4.0);
  problem.camera.position.z = 1.0;
  problem.keepDepth = false;
  problem.direction = glm::normalize(Vec3(-0.3, 0.0, 1.0));
  const SeenTip solved = solveSeenTip(problem);
  CHECK(solved.tip.z <= 1.0 - nearestSeen + 1e-9);
  CHECK(std::isfinite(solved.seen));
}

TEST_CASE("a path that is scaled as seen keeps every point's depth, and its tip looks as long as it should") {
  TipProblem problem = pathAlong(Vec3(0.6, 0.0, 0.8), 3.0);
  problem.sight = SightWish{cameraFrom(Vec3(0.0, 0.0, 1.0)), true, true};
  const TipSolution solution = solveTip(problem);
  REQUIRE(solution.reached());
  CHECK(glm::length(solution.tip - Vec3(1.8, 0.0, 0.8)) < 1e-12);
  CHECK(solution.trailScale.value() == Approx(1.0 + 1.2 / 0.3)); // half of the path lies before its pivot
  for (const Vec3& original : problem.points) {
    CHECK(exaggeratePoint(solution, original).z == Approx(original.z));
  }
  CHECK(glm::length(exaggeratePoint(solution, problem.points.back()) - solution.tip) < 1e-12);
  CHECK(glm::length(exaggeratePoint(solution, problem.points.front()) - problem.points.front()) < 1e-12);
  problem.sight->keepDepth = false;
  const TipSolution deep = solveTip(problem);
  CHECK(glm::length(deep.tip - Vec3(1.8, 0.0, 2.4)) < 1e-12);
  CHECK(glm::length(exaggeratePoint(deep, problem.points.back()) - deep.tip) < 1e-12);
  problem.scale = 9.0;
  const TipSolution far = solveTip(problem);
  CHECK_FALSE(far.reached());
  CHECK(far.outcome == TipOutcome::closest);
  CHECK(far.pull == Vec3(0.0));
}

TEST_CASE("a path straight at the camera is carried across as a whole, weighted, and stays at its pivot") {
  TipProblem problem = pathAlong(Vec3(0.01, 0.0, 1.0), 3.0);
  problem.points.front() += Vec3(0.0, 0.1, 0.0);
  problem.sight = SightWish{cameraFrom(Vec3(0.0, 0.0, 1.0)), true, true};
  problem.basePosition = Vec3(-0.5, 0.0, 0.0);
  problem.limbLength = glm::length(problem.points.back() - problem.basePosition);
  problem.axes = {true, false, true};
  const TipSolution solution = solveTip(problem);
  REQUIRE(solution.reached());
  CHECK(solution.trailScale.value() == 1.0);
  CHECK(glm::length(solution.pull - Vec3(2.0 * 0.51, 0.0, 0.0)) < 1e-9);
  CHECK(glm::length(problem.points.back() + solution.pull - solution.tip) < 1e-12);
}

TEST_CASE("a path that comes back on itself is moved as seen") {
  TipProblem problem = pathAlong(Vec3(1.0, 0.0, 0.0), 2.0);
  problem.points = {Vec3(0.9, 0.0, 0.0), Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.2)};
  problem.limbLength = glm::length(problem.points.back());
  problem.sight = SightWish{cameraFrom(Vec3(0.0, 0.0, 1.0)), true, true};
  const TipSolution solution = solveTip(problem);
  REQUIRE(solution.moved);
  CHECK(solution.reached());
  CHECK(glm::length(solution.shift - Vec3(1.0, 0.0, 0.0)) < 1e-12);
}

TEST_CASE(
    "turned to the view the path keeps its length, and turns no farther than it may and than it has to") {
  TipProblem problem = pathAlong(Vec3(0.0, 0.6, 0.8), 2.0);
  const double towards = std::asin(0.8); // of the limb and the picture
  problem.sight = SightWish{cameraFrom(Vec3(0.0, 0.0, 1.0)), false, true, 0.0};
  CHECK_FALSE(solveTip(problem).turn.has_value());
  CHECK(glm::length(solveTip(problem).tip - Vec3(0.0, 1.2, 1.6)) < 1e-12);
  problem.sight->largestTurnRadians = 0.3;
  const TipSolution some = solveTip(problem);
  CHECK(glm::length(some.tip) == Approx(2.0));
  CHECK(some.tip.z == Approx(2.0 * std::sin(towards - 0.3)));
  CHECK(some.tip.y > 1.2);
  CHECK(glm::length(exaggeratePoint(some, problem.points.back()) - some.tip) < 1e-12);
  problem.sight->largestTurnRadians = 1.5;
  CHECK(solveTip(problem).tip.z == Approx(0.0).margin(1e-12));
  problem.points = pathAlong(Vec3(0.0, 0.0, 1.0), 2.0).points; // straight at the camera: sideways
  problem.sight->largestTurnRadians = 1.6;
  CHECK(glm::length(solveTip(problem).tip - Vec3(2.0, 0.0, 0.0)) < 1e-9);
}

#include "rig/ik/limb_shape.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/described_limbs.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

// A limb of the x-y plane that bends to the side by an angle at each inner joint.
LimbShapeProblem bentLimb(std::vector<double> boneLengths, double bendRadians) {
  LimbShapeProblem problem;
  problem.points = {Vec3(0.3, 1.2, -0.1)};
  double angle = 0.4;
  for (const double length : boneLengths) {
    problem.points.push_back(problem.points.back() + length * Vec3(std::cos(angle), std::sin(angle), 0.0));
    problem.restLength += length;
    angle += bendRadians;
  }
  problem.bendNormal = Vec3(0, 0, 1);
  problem.shortestReach = 1e-3 * problem.restLength;
  problem.target = problem.points.back();
  return problem;
}

double reachOf(const LimbShapeProblem& problem) {
  return glm::length(problem.points.back() - problem.points.front());
}

// Where the limb's joints come to when each bone turns and stretches as the shape says.
std::vector<Vec3> shapedPoints(const LimbShapeProblem& problem, const LimbShape& shape) {
  std::vector<Vec3> points{problem.points.front()};
  for (std::size_t i = 1; i < problem.points.size(); ++i) {
    points.push_back(points.back() +
                     shape.stretch * (shape.turns[i - 1] * (problem.points[i] - problem.points[i - 1])));
  }
  return points;
}

void aimAt(LimbShapeProblem& problem, const Vec3& direction, double reach) {
  problem.target = problem.points.front() + glm::normalize(direction) * reach;
}

bool isFinite(const LimbShape& shape) {
  bool finite = std::isfinite(shape.stretch) && std::isfinite(glm::length(shape.end));
  for (const Quat& turn : shape.turns) {
    finite = finite && std::abs(glm::length(turn) - 1.0) < 1e-6;
  }
  return finite;
}

} // namespace

TEST_CASE("a limb whose target is where its end is stays as it is") {
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    for (const double angle : {0.0, 1e-5, 0.02, 0.7, 2.5}) {
      for (const std::vector<double>& bones :
           {std::vector{0.5}, std::vector{0.3, 0.25}, std::vector{0.1, 0.1, 0.12, 0.1}}) {
        LimbShapeProblem problem = bentLimb(bones, angle);
        problem.bend = bend;
        CAPTURE(angle, bones.size(), bend == Bend::keep);
        const LimbShape shape = solveLimbShape(problem);
        const std::vector<Vec3> points = shapedPoints(problem, shape);
        for (std::size_t i = 0; i < points.size(); ++i) {
          CHECK(glm::length(points[i] - problem.points[i]) < 1e-7);
        }
      }
    }
  }
}

TEST_CASE(
    "keeping the bend grows and turns the limb as one: the elbow keeps its angle, the end is at the target") {
  LimbShapeProblem problem = bentLimb({0.3, 0.25}, 0.8);
  const double elbow = test::innerAngle(problem.points);
  for (const double scale : {0.5, 0.8, 1.0, 2.0, 3.0}) {
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0.4), Vec3(-1, 0.2, 0.3), Vec3(0, 0, -1)}) {
      aimAt(problem, direction, scale * reachOf(problem));
      CAPTURE(scale, direction.x, direction.y, direction.z);
      const LimbShape shape = solveLimbShape(problem);
      const std::vector<Vec3> points = shapedPoints(problem, shape);
      CHECK(shape.stretch == Approx(scale).epsilon(1e-9));
      CHECK(test::innerAngle(points) == Approx(elbow).margin(1e-9));
      CHECK(glm::length(points.back() - problem.target) < 1e-5 * reachOf(problem));
      CHECK(glm::length(points.back() - shape.end) < 1e-9);
    }
  }
}

TEST_CASE("a lowered switch takes on that part of the wanted length and still points at the target") {
  LimbShapeProblem problem = bentLimb({0.3, 0.25}, 0.8);
  problem.stretchSwitch = 0.25;
  aimAt(problem, Vec3(0, 1, 0), 3.0 * reachOf(problem));
  const LimbShape shape = solveLimbShape(problem);
  CHECK(shape.stretch == Approx(1.5));
  const Vec3 reached = shape.end - problem.points.front();
  CHECK(angleBetween(reached, problem.target - problem.points.front()) < 1e-6);
}

TEST_CASE("straightening reaches targets within the limb's length without any stretch") {
  for (const std::vector<double>& bones :
       {std::vector{0.3, 0.25}, std::vector{0.1, 0.1, 0.12}, std::vector{0.1, 0.1, 0.1, 0.1}}) {
    LimbShapeProblem problem = bentLimb(bones, 0.5);
    problem.bend = Bend::straighten;
    problem.straightenAmount = 0.0;
    for (const double share : {0.75, 0.9, 0.99, 1.0}) {
      aimAt(problem, Vec3(0.2, 1, 0.3), share * problem.restLength);
      CAPTURE(bones.size(), share);
      const LimbShape shape = solveLimbShape(problem);
      CHECK(shape.stretch == Approx(1.0).epsilon(1e-12));
      CHECK(glm::length(shapedPoints(problem, shape).back() - problem.target) < 1e-6);
    }
  }
}

TEST_CASE("a straightened limb stretches past its length and never leaves the trail with the switch on") {
  LimbShapeProblem problem = bentLimb({0.3, 0.25}, 1.1);
  problem.bend = Bend::straighten;
  for (const double amount : {0.0, 0.3, 1.0}) {
    for (const double scale : {1.01, 2.0, 5.0}) {
      problem.straightenAmount = amount;
      aimAt(problem, Vec3(1, -1, 0.2), scale * problem.restLength);
      const LimbShape shape = solveLimbShape(problem);
      CAPTURE(amount, scale);
      CHECK(shape.stretch == Approx(scale).epsilon(1e-9));
      CHECK(glm::length(shapedPoints(problem, shape).back() - problem.target) < 1e-6);
    }
  }
}

TEST_CASE("a limb that straightens to be squashed curls until it is at the target") {
  for (const std::vector<double>& bones :
       {std::vector{0.5}, std::vector{0.3, 0.25}, std::vector{0.1, 0.1, 0.12},
        std::vector{0.1, 0.1, 0.1, 0.1, 0.1}}) {
    for (const double bend : {0.0, 0.05, 0.5}) {
      LimbShapeProblem problem = bentLimb(bones, bend);
      problem.bend = Bend::straighten;
      problem.grows = false;
      const double reach = reachOf(problem);
      for (const double w : {0.0, 0.2, 0.5, 0.8, 1.0}) {
        problem.straightenAmount = w;
        aimAt(problem, problem.points.back() - problem.points.front(), (1.0 - 0.5 * w) * reach);
        CAPTURE(bones.size(), bend, w);
        CHECK(glm::length(shapedPoints(problem, solveLimbShape(problem)).back() - problem.target) < 1e-6);
      }
    }
  }
}

TEST_CASE("a hind leg that is squashed folds at its own joints, each on the way it is bent") {
  LimbShapeProblem problem = bentLimb({0.4}, 0.0);
  for (const double angle : {-0.45, 0.5}) {
    problem.points.push_back(problem.points.back() + 0.3 * Vec3(std::cos(angle), std::sin(angle), 0.1));
    problem.restLength += 0.3;
  }
  problem.bend = Bend::straighten;
  for (const double share : {0.9, 0.7, 0.5}) {
    CAPTURE(share);
    aimAt(problem, problem.points.back() - problem.points.front(), share * reachOf(problem));
    const std::vector<Vec3> points = shapedPoints(problem, solveLimbShape(problem));
    CHECK(glm::length(points.back() - problem.target) < 1e-6);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto bendOf = [&](const std::vector<Vec3>& of) {
        return glm::cross(of[i] - of[i - 1], of[i + 1] - of[i]);
      };
      CHECK(glm::dot(bendOf(points), bendOf(problem.points)) > 0.0);
    }
  }
}

TEST_CASE(
    "a limb that is bent against its usual side is bent farther or less on the side that it is bent to") {
  const std::vector<double> bones =
      GENERATE(std::vector{0.3, 0.25}, std::vector{0.3, 0.3}, std::vector{0.2, 0.2, 0.2, 0.2});
  const double bend = GENERATE(0.6, -0.6); // radians at each inner joint, against the normal where below 0
  const double share = GENERATE(0.7, 0.9, 1.02);
  CAPTURE(bones.size(), bend, share);
  LimbShapeProblem problem = bentLimb(bones, bend);
  problem.bend = Bend::straighten;
  const Vec3 line = problem.target - problem.points.front();
  aimAt(problem, line, share * glm::length(line));
  const LimbShape shape = solveLimbShape(problem);
  const std::vector<Vec3> points = shapedPoints(problem, shape);
  CHECK(glm::length(points.back() - problem.target) < 1e-6);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before =
        glm::cross(problem.points[i] - problem.points[i - 1], problem.points[i + 1] - problem.points[i]).z;
    const double after = glm::cross(points[i] - points[i - 1], points[i + 1] - points[i]).z;
    CHECK(before * after > 0.0);
    CHECK((std::abs(after) > std::abs(before)) == (share < 1.0));
  }
}

TEST_CASE("a straightening limb never flips while its target sweeps through its reach") {
  LimbShapeProblem problem = bentLimb({0.3, 0.25}, 0.6);
  problem.bend = Bend::straighten;
  problem.straightenAmount = 1.0;
  Vec3 elbowBefore(0.0);
  bool first = true;
  for (double share = 0.2; share < 2.0; share += 0.002) {
    aimAt(problem, Vec3(std::cos(2.0 * share), std::sin(2.0 * share), 0.1), share * problem.restLength);
    const LimbShape shape = solveLimbShape(problem);
    const Vec3 elbow = shapedPoints(problem, shape)[1];
    CAPTURE(share);
    if (!first) {
      // Near the straight pose the elbow moves as the root of the distance, hence the room.
      CHECK(glm::length(elbow - elbowBefore) < 0.03);
    }
    // Towards the same side of the chord as in the pose that came in, or straight.
    const Vec3 chord = shape.end - problem.points.front();
    CHECK(glm::dot(Vec3(0, 0, 1), glm::cross(elbow - problem.points.front(), chord)) > -1e-9);
    elbowBefore = elbow;
    first = false;
  }
}

TEST_CASE("the turn stays continuous while the target goes around through 180 degrees") {
  const Vec3 from(1, 0, 0);
  for (const double tilt : {0.0, 1e-9, 0.02, 0.1, -0.1}) {
    Quat before(1, 0, 0, 0);
    for (double degrees = 0.0; degrees <= 360.0; degrees += 0.25) {
      const double angle = degrees * pi / 180.0;
      const Vec3 to =
          glm::normalize(Vec3(std::cos(angle), std::sin(angle), tilt * std::abs(std::sin(angle / 2))));
      const Quat turn = steadyTurn(from, to, Vec3(0, 0, 1));
      CAPTURE(tilt, degrees);
      CHECK(angleBetween(turn * from, to) < 1e-5);
      // A quarter of a degree of the target may turn the limb by a few degrees where the turns go over into
      // each other.
      CHECK(std::abs(glm::dot(turn, before)) > std::cos(0.5 * 6.0 * pi / 180.0));
      before = turn;
    }
  }
}

TEST_CASE("the stretch is kept within its limits, and says so") {
  LimbShapeProblem problem = bentLimb({0.3, 0.25}, 0.8);
  aimAt(problem, Vec3(0, 1, 0), 100.0 * reachOf(problem));
  CHECK(solveLimbShape(problem).stretch == largestStretch);
  CHECK(solveLimbShape(problem).outcome == ShapeOutcome::clamped);
  aimAt(problem, Vec3(0, 1, 0), 1e-6 * reachOf(problem));
  CHECK(solveLimbShape(problem).stretch == smallestStretch);
  CHECK(solveLimbShape(problem).outcome == ShapeOutcome::clamped);
}

TEST_CASE("a limb folded shorter than its shortest reach does not jump when its target starts to move") {
  LimbShapeProblem problem = bentLimb({0.3, 0.3 - 1e-4}, pi);
  problem.shortestReach = 1e-3;
  REQUIRE(reachOf(problem) < problem.shortestReach);
  problem.target += Vec3(1e-9, 0, 0);
  CHECK(solveLimbShape(problem).stretch == Approx(1.0).margin(1e-5));
}

TEST_CASE("a target that passes through the base leaves everything finite") {
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    LimbShapeProblem problem = bentLimb({0.3, 0.25}, 0.8);
    problem.bend = bend;
    for (int i = -10; i <= 10; ++i) {
      problem.target = problem.points.front() + 0.01 * i * Vec3(1, 0, 0);
      CHECK(isFinite(solveLimbShape(problem)));
    }
  }
}

TEST_CASE("a limb without length stays as it is") {
  LimbShapeProblem problem;
  problem.points = {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)};
  problem.target = Vec3(2, 2, 3);
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    problem.bend = bend;
    const LimbShape shape = solveLimbShape(problem);
    CHECK(shape.outcome == ShapeOutcome::degenerate);
    CHECK(shape.isIdentity());
    CHECK(shape.end == Vec3(1, 2, 3));
  }
}

TEST_CASE("random problems give finite shapes, reached or said not to be") {
  std::mt19937 random(20240717);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto chance = [&](double share) { return number(random) < 2.0 * share - 1.0; };
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 20000; ++i) {
    LimbShapeProblem problem;
    const int joints = 2 + i % 5;
    for (int j = 0; j < joints; ++j) {
      const bool repeats = !problem.points.empty() && chance(0.1);
      problem.points.push_back(repeats ? problem.points.back() : vector() * (chance(0.1) ? 1e-12 : 1.0));
    }
    problem.target = chance(0.1) ? problem.points[static_cast<std::size_t>(i % joints)] : 3.0 * vector();
    const Vec3 normal = vector();
    problem.bendNormal = chance(0.3) ? Vec3(0.0) : glm::normalize(normal);
    problem.shortestReach = chance(0.2) ? 0.0 : 1e-3;
    problem.stretchSwitch = chance(0.5) ? 1.0 : std::abs(number(random));
    problem.bend = chance(0.5) ? Bend::keep : Bend::straighten;
    problem.restLength = chance(0.1) ? 0.0 : 2.0 * std::abs(number(random));
    problem.straightenAmount = chance(0.5) ? 1.0 : number(random);
    problem.grows = chance(0.5);
    CAPTURE(i);
    const LimbShape shape = solveLimbShape(problem);
    REQUIRE(isFinite(shape));
    REQUIRE(shape.turns.size() + 1 == problem.points.size());
    REQUIRE(shape.stretch >= smallestStretch);
    REQUIRE(shape.stretch <= largestStretch);
  }
}

// A spine under its three controls, against the curve and the turns that they ask for.
#include "rig/ik/spline_spine.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/rotation.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

const Vec3 upwards(0.0, 1.0, 0.0);

/// Four bones of unequal length, straight up.
SplineSpineProblem uprightSpine() {
  SplineSpineProblem problem;
  for (const double height : {0.0, 0.1, 0.4, 0.6, 1.0}) {
    problem.points.push_back(Vec3(0.2, 1.0, -0.1) + height * upwards);
    problem.along.push_back(height);
  }
  return problem;
}

double lengthAt(const std::vector<Vec3>& points, std::size_t bone) {
  return glm::length(points[bone + 1] - points[bone]);
}

/// The turn of a bone about its own way, radians in (-pi, pi], where it does not swing.
double twistOf(const Quat& turn) {
  return 2.0 * std::atan2(turn.y, turn.w);
}

} // namespace

TEST_CASE("A spine whose controls rest is as it was, exactly") {
  const SplineSpineProblem problem = uprightSpine();
  const SplineSpineShape shape = solveSplineSpine(problem);
  CHECK(shape.points == problem.points);
  CHECK(shape.wanted == problem.points);
  CHECK(shape.turns == std::vector<Quat>(4, Quat(1.0, 0.0, 0.0, 0.0)));
  CHECK(shape.stretches == std::vector<double>(4, 1.0));
  CHECK(shape.topTurn == Quat(1.0, 0.0, 0.0, 0.0));
}

TEST_CASE("Each control asks for its share of every point: low and top along the line, middle as a bow") {
  const Vec3 low(0.1, 0.02, 0.0), middle(0.0, 0.03, 0.2), top(-0.3, 0.1, 0.05);
  const auto [withLow, withMiddle, withTop] = GENERATE(
      table<double, double, double>({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.5, 0.7}}));
  SplineSpineProblem problem = uprightSpine();
  problem.low = withLow * low;
  problem.middle = withMiddle * middle;
  problem.top = withTop * top;
  const SplineSpineShape shape = solveSplineSpine(problem);
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const double u = problem.along[i];
    const Vec3 moved =
        (1.0 - u) * withLow * low + 4.0 * u * (1.0 - u) * withMiddle * middle + u * withTop * top;
    CHECK(glm::length(shape.wanted[i] - problem.points[i] - moved) < 1e-12);
    CHECK(glm::length(shape.points[i] - shape.wanted[i]) < 1e-12); // It may stretch so far.
  }
  for (std::size_t bone = 0; bone < 4; ++bone) {
    CHECK(shape.stretches[bone] == Approx(lengthAt(shape.points, bone) / lengthAt(problem.points, bone)));
    const Vec3 way = glm::normalize(shape.points[bone + 1] - shape.points[bone]);
    CHECK(glm::length(shape.turns[bone] * upwards - way) < 1e-7);
  }
}

TEST_CASE("Bones that may not stretch are laid along the way that the controls ask for") {
  SplineSpineProblem problem = uprightSpine();
  problem.top = 0.5 * upwards;
  const auto reached = [&](double stretchSwitch) {
    problem.stretchSwitch = stretchSwitch;
    return solveSplineSpine(problem);
  };
  for (const double part : {0.0, 0.3, 1.0}) {
    const SplineSpineShape shape = reached(part);
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      const double height = problem.along[i] * (1.0 + 0.5 * part);
      CHECK(shape.points[i].y == Approx(1.0 + height));
    }
    for (std::size_t bone = 0; bone < 4; ++bone) {
      CHECK(shape.stretches[bone] == Approx(1.0 + 0.5 * part));
    }
    CHECK(shape.wanted.back().y == Approx(2.5));
  }
  problem.top = -0.5 * upwards; // Squashed, it reaches past where the controls are.
  CHECK(reached(0.0).points.back().y == Approx(2.0));
  CHECK(reached(1.0).points.back().y == Approx(1.5));
}

TEST_CASE("The turn of the top is spread along the spine, each bone's by where its middle is") {
  const double angle = GENERATE(0.8, -1.2, 3.0, 5.0, -7.0); // More than half a turn, and than a whole one.
  SplineSpineProblem problem = uprightSpine();
  problem.turn = angle * upwards;
  const SplineSpineShape shape = solveSplineSpine(problem);
  const std::vector<double> middles{0.05, 0.25, 0.5, 0.8};
  for (std::size_t bone = 0; bone < 4; ++bone) {
    const double wanted = middles[bone] * angle;
    CHECK(std::remainder(twistOf(shape.turns[bone]) - wanted, 2.0 * pi) == Approx(0.0).margin(1e-9));
    CHECK(shape.points[bone] == problem.points[bone]);
  }
  CHECK(std::abs(glm::dot(shape.topTurn, axisAngle(upwards, angle))) == Approx(1.0));
}

TEST_CASE("A turn of the top across the spine twists no bone, one aslant by its part along the bone") {
  SplineSpineProblem problem = uprightSpine();
  problem.turn = Vec3(0.9, 0.0, 0.0);
  for (const Quat& turn : solveSplineSpine(problem).turns) {
    CHECK(twistOf(turn) == Approx(0.0).margin(1e-12));
  }
  const double angle = 1.0;
  const Vec3 axis(0.6, 0.8, 0.0);
  problem.turn = angle * axis;
  const double part = 2.0 * std::atan2(std::sin(0.5 * angle) * 0.8, std::cos(0.5 * angle));
  CHECK(twistOf(solveSplineSpine(problem).turns[2]) == Approx(0.5 * part));
}

TEST_CASE("A bone without length stays one, and does not turn") {
  SplineSpineProblem problem = uprightSpine();
  problem.points.insert(problem.points.begin() + 2, problem.points[2]);
  problem.along.insert(problem.along.begin() + 2, problem.along[2]);
  problem.top = Vec3(0.3, 0.1, 0.0);
  problem.turn = 0.5 * upwards;
  const SplineSpineShape shape = solveSplineSpine(problem);
  CHECK(shape.points[2] == shape.points[3]);
  CHECK(shape.stretches[2] == 1.0);
  CHECK(std::abs(shape.turns[2].w) == Approx(1.0));
  CHECK(glm::length(shape.points.back() - problem.points.back() - problem.top) < 1e-12);
}

TEST_CASE("Points are laid along a line by their length from its start, and straight on past its end") {
  const std::vector<Vec3> corner{Vec3(0.0), Vec3(3.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0), Vec3(3.0, 4.0, 0.0)};
  const std::vector<Vec3> laid = laidAlong(corner, {0.0, 1.0, 3.0, 5.0, 7.0, 9.0});
  CHECK(laid == std::vector<Vec3>{Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0), Vec3(3.0, 2.0, 0.0),
                                  Vec3(3.0, 4.0, 0.0), Vec3(3.0, 6.0, 0.0)});
  CHECK(laidAlong({Vec3(2.0), Vec3(2.0)}, {1.0}) == std::vector<Vec3>{Vec3(2.0)});
}

TEST_CASE("A rotation vector turns about its direction by its length") {
  CHECK(rotationOfVector(Vec3(0.0)) == Quat(1.0, 0.0, 0.0, 0.0));
  const Quat turn = rotationOfVector(Vec3(0.0, 0.0, 0.5 * pi));
  CHECK(glm::length(turn * Vec3(1.0, 0.0, 0.0) - upwards) < 1e-12);
  CHECK(glm::length(rotationOfVector(Vec3(0.0, 0.0, -0.25 * pi)) * Vec3(1.0, 0.0, 0.0) -
                    Vec3(std::sqrt(0.5), -std::sqrt(0.5), 0.0)) < 1e-12);
}

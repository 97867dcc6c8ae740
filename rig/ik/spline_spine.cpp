#include "rig/ik/spline_spine.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/math/rotation.h"
#include "rig/ik/limb_shape.h"

namespace stretch::rig {

namespace {

// The part of a rotation about an axis, radians; of the turns that look alike the one nearest to what the
// rotation vector says.
double twistAbout(const Vec3& unitAxis, const Vec3& rotationVector) {
  const Quat turn = rotationOfVector(rotationVector);
  const double alike = 2.0 * std::atan2(glm::dot(Vec3(turn.x, turn.y, turn.z), unitAxis), turn.w);
  const double near = glm::dot(rotationVector, unitAxis);
  return alike + 2.0 * pi * std::round((near - alike) / (2.0 * pi));
}

Vec3 moveAt(const SplineSpineProblem& problem, double u) {
  return (1.0 - u) * problem.low + u * problem.top + 4.0 * u * (1.0 - u) * problem.middle;
}

bool isStill(const SplineSpineProblem& problem) {
  const Vec3 none(0.0);
  return problem.low == none && problem.middle == none && problem.top == none && problem.turn == none;
}

double mixedLength(double own, double asked, double stretchSwitch) {
  const double mixed = own + stretchSwitch * (asked - own);
  return own > 0.0 ? std::clamp(mixed, smallestStretch * own, largestStretch * own) : 0.0;
}

void layOut(const SplineSpineProblem& problem, SplineSpineShape& shape) {
  std::vector<double> lengths{0.0};
  for (std::size_t i = 0; i + 1 < problem.points.size(); ++i) {
    const double own = glm::length(problem.points[i + 1] - problem.points[i]);
    const double asked = glm::length(shape.wanted[i + 1] - shape.wanted[i]);
    lengths.push_back(lengths.back() + mixedLength(own, asked, problem.stretchSwitch));
  }
  shape.points = laidAlong(shape.wanted, lengths);
  for (std::size_t i = 0; i + 1 < problem.points.size(); ++i) {
    const double own = glm::length(problem.points[i + 1] - problem.points[i]);
    shape.stretches.push_back(own > 0.0 ? (lengths[i + 1] - lengths[i]) / own : 1.0);
  }
}

} // namespace

Quat rotationOfVector(const Vec3& rotationVector) {
  const double angle = glm::length(rotationVector);
  return angle > 0.0 ? axisAngle(rotationVector / angle, angle) : Quat(1.0, 0.0, 0.0, 0.0);
}

std::vector<Vec3> laidAlong(const std::vector<Vec3>& polyline, const std::vector<double>& lengths) {
  std::vector<Vec3> laid;
  for (const double length : lengths) {
    double left = length;
    Vec3 point = polyline.front();
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
      const Vec3 piece = polyline[i + 1] - polyline[i];
      const double pieceLength = glm::length(piece);
      const bool isLast = i + 2 == polyline.size();
      if (left <= pieceLength || isLast) {
        point = pieceLength > 0.0 ? polyline[i] + piece * (left / pieceLength) : polyline[i];
        break;
      }
      left -= pieceLength;
    }
    laid.push_back(point);
  }
  return laid;
}

SplineSpineShape solveSplineSpine(const SplineSpineProblem& problem) {
  check(problem.points.size() >= 2 && problem.points.size() == problem.along.size(),
        "a spine has a base and an end, and a place along it for each point");
  SplineSpineShape shape;
  const std::size_t bones = problem.points.size() - 1;
  if (isStill(problem)) {
    shape.wanted = problem.points;
    shape.points = problem.points;
    shape.turns.assign(bones, Quat(1.0, 0.0, 0.0, 0.0));
    shape.stretches.assign(bones, 1.0);
    return shape;
  }
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    shape.wanted.push_back(problem.points[i] + moveAt(problem, problem.along[i]));
  }
  layOut(problem, shape);
  for (std::size_t i = 0; i < bones; ++i) {
    const Vec3 after = shape.points[i + 1] - shape.points[i];
    const Quat swing = shortestArc(problem.points[i + 1] - problem.points[i], after);
    const double middle = 0.5 * (problem.along[i] + problem.along[i + 1]);
    const double length = glm::length(after);
    const double twist = length > 0.0 ? middle * twistAbout(after / length, problem.turn) : 0.0;
    shape.turns.push_back(length > 0.0 ? glm::normalize(axisAngle(after / length, twist) * swing) : swing);
  }
  shape.topTurn = rotationOfVector(problem.turn);
  return shape;
}

} // namespace stretch::rig

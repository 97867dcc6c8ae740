#include "app/evaluate/free_turns.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/math/rotation.h"
#include "core/math/transform.h"

namespace stretch::app {

namespace {

constexpr double degreesOfRadian = 180.0 / pi;

double degreesBetween(const Quat& a, const Quat& b) {
  return degreesOfRadian * angleBetween(a, b);
}

// How far the offsets turn what carries the limb from the one frame to the other.
double carriedDegrees(const LimbStep& source, const LimbStep& moved) {
  double most = 0.0;
  for (std::size_t i = 0; i < moved.after.carriers.size(); ++i) {
    most = std::max(most, degreesBetween(moved.before.carriers[i] * glm::inverse(source.before.carriers[i]),
                                         moved.after.carriers[i] * glm::inverse(source.after.carriers[i])));
  }
  return most;
}

// Whether the end is about as near to the base as the bones allow: there the ends tell no direction.
bool isFolded(const std::vector<Vec3>& points) {
  constexpr double near = 0.03; // of the length
  double length = 0.0;
  double longest = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += glm::distance(points[i], points[i + 1]);
    longest = std::max(longest, glm::distance(points[i], points[i + 1]));
  }
  return glm::distance(points.front(), points.back()) <= 2.0 * longest - length + near * length;
}

// The angle by which a bone turns if the plane of the limb is carried over with the line from base to end.
double forcedDegrees(const LimbStep& moved, std::size_t bone) {
  const auto lineOf = [](const std::vector<Vec3>& points) { return points.back() - points.front(); };
  const auto boneOf = [&](const std::vector<Vec3>& points) { return points[bone + 1] - points[bone]; };
  const Vec3 before = boneOf(moved.before.points);
  const Vec3 after = boneOf(moved.after.points);
  const Vec3 newLine = lineOf(moved.after.points);
  const double lengths = glm::length(after) * glm::length(newLine);
  if (!(lengths > 0.0)) {
    return 180.0; // without a line nothing says what the ends make of it
  }
  const Vec3 line = glm::normalize(newLine);
  const Vec3 carried = shortestArc(lineOf(moved.before.points), newLine) * before;
  const double along = glm::dot(after, newLine) / lengths;
  const Vec3 across = carried - glm::dot(carried, line) * line;
  const double side = std::sqrt(std::max(0.0, 1.0 - along * along));
  const double length = glm::length(across);
  return degreesOfRadian * angleBetween(before, along * line + (length > 0.0 ? side / length : 0.0) * across);
}

} // namespace

TurnedLimb turnedLimb(const rig::Limb& limb, const std::vector<NodeIndex>& carriers,
                      const FrameState& frame) {
  const auto rotations = [&](const std::vector<NodeIndex>& nodes) {
    std::vector<Quat> all;
    std::ranges::transform(nodes, std::back_inserter(all),
                           [&](NodeIndex node) { return rotationOf(frame.worlds[at(node)]); });
    return all;
  };
  return {rig::limbPoints(limb, frame), rotations(limb.joints), rotations(carriers)};
}

FreeTurn freeTurn(const LimbStep& source, const LimbStep& moved, double allowedDegrees) {
  FreeTurn worst;
  for (std::size_t i = 0; i < moved.after.joints.size(); ++i) {
    const FreeTurn turn{degreesBetween(moved.before.joints[i], moved.after.joints[i]),
                        degreesBetween(source.before.joints[i], source.after.joints[i])};
    if (turn.excess() <= std::max(allowedDegrees, worst.excess())) {
      continue;
    }
    const double allowed = 2.0 * turn.sourceDegrees + allowedDegrees + carriedDegrees(source, moved);
    if (turn.degrees > allowed && !isFolded(moved.before.points) && !isFolded(moved.after.points) &&
        forcedDegrees(moved, std::min(i, moved.after.points.size() - 2)) <= allowed) {
      worst = turn;
    }
  }
  return worst;
}

} // namespace stretch::app

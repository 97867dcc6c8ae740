#include "rig/ik/two_bone.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

// The pose: its lengths, its line, and which way it bends.
struct Triangle {
  double first = 0.0;
  double second = 0.0;
  double length = 0.0;
  double reach = 0.0;
  double height = 0.0; // of the joint above the line
  Vec3 line{0.0};
  Vec3 bend{0.0};
};

Vec3 acrossPart(const Vec3& vector, const Vec3& unitLine) {
  return vector - unitLine * glm::dot(vector, unitLine);
}

// The direction of the part of a vector across the line; the fallback where there is none.
Vec3 unitAcross(const Vec3& vector, const Vec3& unitLine, double smallest, const Vec3& fallback) {
  const Vec3 across = acrossPart(vector, unitLine);
  const double length = glm::length(across);
  return length > smallest ? across / length : fallback;
}

Triangle triangleOf(const TwoBoneProblem& problem) {
  Triangle triangle;
  triangle.first = glm::length(problem.joint - problem.base);
  triangle.second = glm::length(problem.end - problem.joint);
  triangle.length = triangle.first + triangle.second;
  const Vec3 chord = problem.end - problem.base;
  triangle.reach = glm::length(chord);
  if (triangle.reach > 0.0) {
    constexpr double unseen = 1e-9;
    triangle.line = chord / triangle.reach;
    const Vec3 usual = unitAcross(problem.usualBend, triangle.line, unseen, anyPerpendicular(triangle.line));
    triangle.bend = unitAcross(problem.joint - problem.base, triangle.line, unseen * triangle.length, usual);
    triangle.height = glm::length(acrossPart(problem.joint - problem.base, triangle.line));
  }
  return triangle;
}

// How far the unscaled limb spans on its way to a target at the distance.
double spanFor(const TwoBoneProblem& problem, const Triangle& triangle, double distance) {
  const double nearest =
      std::min(std::abs(triangle.first - triangle.second) + 0.02 * triangle.length, triangle.reach);
  const double reached = problem.isExact
                             ? std::min(distance, triangle.length)
                             : softReach(triangle.length, triangle.reach, distance, problem.softness);
  return std::max(reached, nearest);
}

// The joint of the unscaled limb that spans `span`: along the line, and above it.
Vec2 jointInPlane(const Triangle& triangle, double span) {
  const double along =
      (triangle.first * triangle.first + span * span - triangle.second * triangle.second) / (2.0 * span);
  const double clamped = std::clamp(along, -triangle.first, triangle.first);
  return {clamped, std::sqrt(std::max(0.0, triangle.first * triangle.first - clamped * clamped))};
}

// How far the joint may stand beside the line for the usual bend to count at all: the farther, the more the
// limb's own is against it.
double vagueHeight(const Triangle& triangle, const Vec3& usual) {
  constexpr double vagueOfLength = 0.06;
  const double against = smoothstep(0.5 - 0.5 * glm::dot(triangle.bend, usual));
  return triangle.length * (vagueOfLength + against * (overextendedOfLength - vagueOfLength));
}

// A limb that stands nearly straight or is overextended, and comes to bend clearly, bends the way it usually
// does.
Vec3 towardsUsual(const TwoBoneProblem& problem, const Triangle& triangle, const Vec3& carried,
                  const Quat& turn, const Vec3& line, double newHeight) {
  if (!(glm::length(problem.usualBend) > 0.0)) {
    return carried;
  }
  const Vec3 before = unitAcross(problem.usualBend, triangle.line, 1e-9, triangle.bend);
  const double straight = 1.0 - smoothstep(triangle.height / vagueHeight(triangle, before));
  const double grown = smoothstep((newHeight - triangle.height) / (straightOfLength * triangle.length));
  const double share = straight * grown;
  if (!(share > 0.0)) {
    return carried;
  }
  const Vec3 usual = unitAcross(turn * before, line, 1e-9, carried);
  return unitAcross((1.0 - share) * carried + share * usual, line, 1e-9, usual);
}

// Columns: along a bone, and square to it in the direction of the normal, which may lean; none where it
// points along the bone.
std::optional<Mat3> axesOf(const Vec3& bone, const Vec3& normal) {
  const Vec3 along = glm::normalize(bone);
  const Vec3 across = acrossPart(normal, along);
  const double length = glm::length(across);
  constexpr double unseen = 1e-9;
  if (!(length > unseen)) {
    return std::nullopt;
  }
  const Vec3 square = across / length;
  return Mat3(along, square, glm::cross(along, square));
}

Quat planeTurn(const Vec3& bone, const Vec3& normal, const Vec3& newBone, const Vec3& newNormal) {
  const std::optional<Mat3> before = axesOf(bone, normal);
  const std::optional<Mat3> now = axesOf(newBone, newNormal);
  return before && now ? glm::normalize(glm::quat_cast(*now * glm::transpose(*before)))
                       : shortestArc(bone, newBone);
}

// With a soft zone of its own; spec of it in docs/controllers.md, Arms and legs.
double softerReach(double length, double poseReach, double distance, double zone) {
  const double start = length - zone;
  const double rest = length - poseReach; // what the pose is short of the full length
  if (distance <= start) {
    return distance;
  }
  if (rest >= zone) {
    return length - zone * std::exp(-(distance - start) / zone);
  }
  if (distance >= poseReach) {
    return length - rest * std::exp(-(distance - poseReach) / zone);
  }
  // From the zone's start, where it goes on as it came, to the pose's own reach, where it is what it is.
  const double span = poseReach - start;
  const double u = (distance - start) / span;
  const double startSlope = span;
  const double endSlope = span * rest / zone;
  const double u2 = u * u;
  const double u3 = u2 * u;
  return (2.0 * u3 - 3.0 * u2 + 1.0) * start + (u3 - 2.0 * u2 + u) * startSlope +
         (3.0 * u2 - 2.0 * u3) * poseReach + (u3 - u2) * endSlope;
}

TwoBoneShape still(const TwoBoneProblem& problem, ShapeOutcome outcome) {
  TwoBoneShape shape;
  shape.joint = problem.joint;
  shape.end = problem.end;
  shape.outcome = outcome;
  return shape;
}

} // namespace

double softReach(double length, double poseReach, double distance, double softness) {
  if (softness > 0.0) {
    return softerReach(length, poseReach, distance, softness * length);
  }
  const double soft = std::min(0.04 * length, length - poseReach);
  if (!(soft > 0.0)) {
    return std::min(distance, length);
  }
  const double start = length - soft;
  return distance <= start ? distance : length - soft * std::exp(-(distance - start) / soft);
}

Vec3 polePlace(const TwoBoneProblem& problem) {
  const Triangle triangle = triangleOf(problem);
  return problem.joint + 0.5 * triangle.length * triangle.bend + problem.poleOffset;
}

TwoBoneShape solveTwoBone(const TwoBoneProblem& problem) {
  const Triangle triangle = triangleOf(problem);
  if (!(triangle.first > 0.0) || !(triangle.second > 0.0) || !(triangle.reach > 0.0)) {
    return still(problem, ShapeOutcome::degenerate);
  }
  const bool moved = problem.target != problem.end;
  const bool bent = glm::length(problem.poleOffset) > 0.0;
  if (!moved && !bent) {
    return still(problem, ShapeOutcome::reached);
  }
  const Vec3 toTarget = problem.target - problem.base;
  const double distance = glm::length(toTarget);
  const double span = moved ? spanFor(problem, triangle, distance) : triangle.reach;
  const double wanted = 1.0 + problem.stretchSwitch * (distance / span - 1.0);
  TwoBoneShape shape;
  shape.scale = moved ? std::clamp(wanted, smallestStretch, largestStretch) : 1.0;
  shape.outcome = moved && shape.scale != wanted ? ShapeOutcome::clamped : ShapeOutcome::reached;
  const Vec3 line = distance > 0.0 ? toTarget / distance : triangle.line;
  const Quat turn = steadyTurn(triangle.line, line, glm::cross(triangle.line, triangle.bend));
  const Vec2 place = jointInPlane(triangle, span);
  Vec3 bend = unitAcross(turn * triangle.bend, line, 1e-9, anyPerpendicular(line));
  bend = towardsUsual(problem, triangle, bend, turn, line, place.y);
  // Old and new pose use one normal: where the pose is too straight to tell it, or bent the other way a
  // little, its own would turn the bones about themselves.
  const Vec3 normal = glm::cross(triangle.line, glm::inverse(turn) * bend);
  if (bent) {
    bend = unitAcross(polePlace(problem) - problem.base, line, 1e-9 * triangle.length, bend);
  }
  const Vec3 newNormal = glm::cross(line, bend);
  const Vec3 joint = place.x * line + place.y * bend;
  shape.turns = {planeTurn(problem.joint - problem.base, normal, joint, newNormal),
                 planeTurn(problem.end - problem.joint, normal, span * line - joint, newNormal)};
  shape.joint = problem.base + shape.scale * joint;
  shape.end = problem.base + shape.scale * span * line;
  return shape;
}

} // namespace stretch::rig

#include "rig/trail/seen_tip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

constexpr double pointsAtCamera = 0.1; // what is left of a unit direction in the picture
constexpr double nothing = 1e-12;

// The picture's distance from base to P1 + x w as a function of x: |g + x h| / (z + x e), times the depth z
// of the tip alone (docs/exaggeration.md, As the camera sees it).
struct SeenLine {
  Vec2 g{0.0};
  Vec2 h{0.0};
  double z = 1.0;
  double e = 0.0;

  [[nodiscard]] double lengthAt(double x) const { return glm::length(g + x * h) / (z + x * e); }
};

SeenLine lineOf(const SeenProblem& problem, const Vec2& baseInPicture, const Vec3& way) {
  const CameraPlace& camera = problem.camera;
  const Vec3 offset = problem.tip - camera.position;
  const bool isPerspective = camera.kind == CameraKind::perspective;
  SeenLine line;
  line.z = isPerspective ? glm::dot(camera.forward, offset) : 1.0;
  line.e = isPerspective ? glm::dot(camera.forward, way) : 0.0;
  line.g = Vec2(glm::dot(camera.right, offset), glm::dot(camera.up, offset)) - line.z * baseInPicture;
  line.h = Vec2(glm::dot(camera.right, way), glm::dot(camera.up, way)) - line.e * baseInPicture;
  return line;
}

// As far as a walk may go: in front of the camera, not past the pivot, not too far from the base.
double longestWalk(const SeenProblem& problem, const SeenLine& line, const Vec3& way) {
  const Vec3 limb = problem.tip - problem.base;
  const double along = glm::dot(limb, way);
  const double room = (farthestSeen * farthestSeen - 1.0) * glm::dot(limb, limb);
  double longest = -along + std::sqrt(along * along + room);
  if (problem.scale < 1.0) {
    longest = std::min(longest, problem.pivotDistance);
  }
  if (line.e < 0.0) {
    longest = std::min(longest, (nearestSeen - line.z) / line.e);
  }
  return std::max(0.0, longest);
}

// Roots of the walk's quadratic, the smaller one first; fewer where it has none.
std::array<std::optional<double>, 2> rootsOf(const SeenLine& line, double wanted) {
  const double a = glm::dot(line.h, line.h) - wanted * wanted * line.e * line.e;
  const double b = glm::dot(line.g, line.h) - wanted * wanted * line.z * line.e;
  const double c = glm::dot(line.g, line.g) - wanted * wanted * line.z * line.z;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    return {};
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)); // no cancellation
  std::optional<double> first = q != 0.0 ? std::optional(c / q) : std::nullopt;
  std::optional<double> second = a != 0.0 ? std::optional(q / a) : std::nullopt;
  if (first && second && *second < *first) {
    std::swap(first, second);
  }
  return {first, second};
}

// Where between 0 and the longest walk the limb looks longest, or shortest.
double bestWalk(const SeenLine& line, double longest, bool isLongest) {
  const double below = line.z * glm::dot(line.h, line.h) - line.e * glm::dot(line.g, line.h);
  const double turn = (line.e * glm::dot(line.g, line.g) - line.z * glm::dot(line.g, line.h)) / below;
  double best = 0.0;
  for (const double x : {longest, turn}) {
    const bool isBetter =
        isLongest ? line.lengthAt(x) > line.lengthAt(best) : line.lengthAt(x) < line.lengthAt(best);
    if (x >= 0.0 && x <= longest && isBetter) {
      best = x;
    }
  }
  return best;
}

// The direction that is walked along, outwards.
void setDirection(const SeenProblem& problem, SeenTip& solved) {
  solved.direction = problem.direction;
  if (!problem.keepDepth) {
    return;
  }
  Vec3 flat = flattened(problem.camera, problem.direction);
  solved.alongLimb = glm::length(flat) < pointsAtCamera;
  if (solved.alongLimb) {
    flat = flattened(problem.camera, problem.tip - problem.base);
  }
  const double length = glm::length(flat);
  solved.direction = length > nothing ? flat / length : Vec3(0.0);
}

} // namespace

SeenTip solveSeenTip(const SeenProblem& problem) {
  SeenTip solved;
  solved.tip = problem.tip;
  setDirection(problem, solved);
  const double now = seenLength(problem.camera, problem.base, problem.tip).value_or(0.0);
  solved.reached = now > nothing;
  if (!solved.reached || problem.scale == 1.0) {
    return solved;
  }
  const double sign = problem.scale > 1.0 ? 1.0 : -1.0;
  const Vec3 way = sign * solved.direction;
  const SeenLine line = lineOf(problem, *inPicture(problem.camera, problem.base), way);
  const double longest = longestWalk(problem, line, way);
  std::optional<double> walked;
  for (const std::optional<double>& root : rootsOf(line, problem.scale * now)) {
    walked = !walked && root && *root >= 0.0 && *root <= longest ? root : walked;
  }
  solved.reached = walked.has_value();
  const double x = walked ? *walked : bestWalk(line, longest, sign > 0.0);
  solved.walk = sign * x;
  solved.tip = problem.tip + x * way;
  solved.seen = line.lengthAt(x) / now;
  return solved;
}

std::optional<double> seenLength(const CameraPlace& camera, const Vec3& from, const Vec3& to) {
  const std::optional<Vec2> begin = inPicture(camera, from);
  const std::optional<Vec2> end = inPicture(camera, to);
  return begin && end ? std::optional(glm::length(*end - *begin)) : std::nullopt;
}

Vec3 flattened(const CameraPlace& camera, const Vec3& direction) {
  return direction - camera.forward * glm::dot(camera.forward, direction);
}

} // namespace stretch::rig

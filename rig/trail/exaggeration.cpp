#include "rig/trail/exaggeration.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/math/polyline.h"
#include "core/math/rotation.h"

namespace stretch::rig {

namespace {

constexpr double reachedTolerance = 1e-4; // of the wanted length
constexpr double stillness = 1e-6;        // of the limb's length: no direction to walk along

Vec3 masked(const std::array<bool, 3>& axes, const Vec3& v) {
  return {axes[0] ? v.x : 0.0, axes[1] ? v.y : 0.0, axes[2] ? v.z : 0.0};
}

// Where a walk from the tip along a line meets the sphere of the wanted radius around the base, or comes
// closest to it.
struct Walk {
  Vec3 end{0.0};
  double signedDistance = 0.0; // along the direction; negative towards the pivot
  bool met = true;
  bool isCut = false; // by the turn limit
};

// Outwards there is exactly one root: the tip is inside the sphere.
Walk walkOutwards(const Vec3& tip, const Vec3& base, const Vec3& direction, double radius) {
  const Vec3 offset = tip - base;
  const double along = glm::dot(offset, direction);
  const double c = glm::dot(offset, offset) - radius * radius;
  const double distance = -along + std::sqrt(std::max(0.0, along * along - c));
  return {tip + direction * distance, distance, true};
}

// Inwards the line may miss the sphere, or meet it beyond `longest`.
Walk walkInwards(const Vec3& tip, const Vec3& base, const Vec3& direction, double radius, double longest) {
  const Vec3 offset = tip - base;
  const double along = glm::dot(offset, direction); // > 0: walking inwards comes nearer to the base
  const double c = glm::dot(offset, offset) - radius * radius;
  const double discriminant = along * along - c;
  const double root = discriminant >= 0.0 ? along - std::sqrt(discriminant) : -1.0;
  if (root >= 0.0 && root <= longest) {
    return {tip - direction * root, -root, true};
  }
  const double closest = std::clamp(along, 0.0, longest);
  return {tip - direction * closest, -closest, false};
}

// How far a walk may turn the limb that it leaves at the angle `aside`. One that comes back towards the base
// would carry the limb past it and turn it over, so it may turn it the less, the straighter it comes back;
// limits beyond 90 degrees let go of that step by step.
double mostTurn(const TipProblem& problem, double aside) {
  const double limit = problem.turnLimitRadians;
  const double hold = aside > 0.5 * pi ? std::clamp(2.0 - limit / (0.5 * pi), 0.0, 1.0) : 0.0;
  return limit * (1.0 + hold * (std::sin(aside) - 1.0));
}

// The walk as far as it may turn the limb: a triangle of which one side and two angles are known.
Walk withinTurn(const TipProblem& problem, const Vec3& tip, const Walk& walked) {
  constexpr double hardly = 1e-9; // radians: walk and limb on one line, within rounding
  const Vec3 limb = tip - problem.basePosition;
  const Vec3 way = walked.end - tip;
  if (!(glm::length(limb) > 0.0) || !(glm::length(way) > 0.0)) {
    return walked;
  }
  const double aside = angleBetween(limb, way);
  const double most = mostTurn(problem, aside);
  const double beyond = std::sin(aside - most);
  if (angleBetween(limb, walked.end - problem.basePosition) <= most + hardly || !(beyond > 0.0)) {
    return walked;
  }
  const double share = glm::length(limb) * std::sin(most) / beyond / glm::length(way);
  return {tip + share * way, share * walked.signedDistance, false, true};
}

Walk walk(const TipProblem& problem, const Vec3& tip, const Vec3& direction, double longestInwards) {
  const double radius = problem.scale * problem.limbLength;
  const double now = glm::length(tip - problem.basePosition);
  if (std::abs(radius - now) <= 1e-12 * std::max(radius, now)) {
    return {tip, 0.0, true};
  }
  const Walk free = radius > now ? walkOutwards(tip, problem.basePosition, direction, radius)
                                 : walkInwards(tip, problem.basePosition, direction, radius, longestInwards);
  return problem.turnLimitRadians < pi ? withinTurn(problem, tip, free) : free;
}

// What the line cannot reach is pulled straight to the wanted length, along the active axes
// only.
Vec3 pullFrom(const TipProblem& problem, const Vec3& closest, const Vec3& originalTip) {
  Vec3 direction = closest - problem.basePosition;
  if (glm::length(direction) < 1e-9 * problem.limbLength) {
    direction = originalTip - problem.basePosition;
  }
  const double length = glm::length(direction);
  if (!(length > 0.0)) {
    return Vec3(0.0);
  }
  const Vec3 wanted = problem.basePosition + direction * (problem.scale * problem.limbLength / length);
  return masked(problem.axes, wanted - closest);
}

// The walk on which the scale counts in the camera's picture. Inwards it gets to where the pivot is seen at
// most.
SeenTip seenWalk(const TipProblem& problem, const Vec3& tip, const Vec3& direction, double longestInwards) {
  const SightWish& sight = *problem.sight;
  const double flat = sight.keepDepth ? glm::length(flattened(sight.camera, direction)) : 1.0;
  const double now = glm::length(tip - problem.basePosition);
  SeenProblem seen{sight.camera, problem.basePosition, tip, direction};
  seen.pivotDistance = longestInwards * flat;
  seen.scale = now > 0.0 ? problem.scale * problem.limbLength / now : problem.scale;
  seen.keepDepth = sight.keepDepth;
  return solveSeenTip(seen);
}

// A path that was scaled or moved by the walk to `solution.seen`.
void finishSeen(const TipProblem& problem, double length, TipSolution& solution) {
  const SeenTip& seen = *solution.seen;
  if (solution.moved) {
    solution.shift = seen.tip - solution.originalTip;
  } else if (seen.alongLimb) { // across the path: nothing of it can be scaled
    solution.pull = seen.tip - solution.originalTip;
  } else {
    solution.trailScale = 1.0 + seen.walk / length;
  }
  solution.tip = seen.tip;
  solution.outcome = seen.reached ? TipOutcome::reached : TipOutcome::closest;
  solution.reachedLength = glm::length(seen.tip - problem.basePosition);
  solution.wantedLength = solution.reachedLength;
}

// Turns the exaggerated path about the limb's base, the nearest way towards the picture.
void turnToView(const TipProblem& problem, TipSolution& solution) {
  const Vec3 limb = solution.tip - problem.basePosition;
  const Vec3 eye = towardsEye(problem.sight->camera, problem.basePosition);
  const Vec3 flat = limb - eye * glm::dot(eye, limb);
  const Vec3 goal = glm::length(flat) > 1e-9 * glm::length(limb) ? flat : problem.sight->camera.right;
  const double wanted = angleBetween(limb, goal);
  const double turned = std::min(wanted, problem.sight->largestTurnRadians);
  if (!(turned > 0.0)) {
    return;
  }
  solution.turn = axisAngle(glm::normalize(glm::cross(limb, goal)), turned);
  solution.tip = problem.basePosition + *solution.turn * limb;
  solution.pull = *solution.turn * solution.pull;
}

Vec3 turned(const TipSolution& solution, const Vec3& point) {
  return solution.turn ? solution.base + *solution.turn * (point - solution.base) : point;
}

void finish(const TipProblem& problem, const Walk& walked, TipSolution& solution) {
  solution.tip = walked.end;
  solution.outcome = walked.met ? TipOutcome::reached : TipOutcome::closest;
  // With an axis off, the pull past the limit would turn the limb on instead of straight out.
  const bool mayPull = !walked.isCut || (problem.axes[0] && problem.axes[1] && problem.axes[2]);
  if (!walked.met && problem.pull && mayPull) {
    solution.pull = pullFrom(problem, walked.end, solution.originalTip);
    solution.tip += solution.pull;
    solution.outcome = TipOutcome::pulled;
  }
  solution.reachedLength = glm::length(solution.tip - problem.basePosition);
}

// The tip is nearer to the pivot than half of the farthest point, so the path is carried as a
// whole.
void moveWhole(const TipProblem& problem, TipSolution& solution) {
  const Vec3 outwards = masked(problem.axes, solution.originalTip - problem.basePosition);
  const double length = glm::length(outwards);
  if (length < stillness * problem.limbLength) {
    solution.outcome = TipOutcome::nothingToScale;
    return;
  }
  solution.moved = true;
  if (solution.seen) {
    solution.seen = seenWalk(problem, solution.originalTip, outwards / length, length);
    finishSeen(problem, length, solution);
    return;
  }
  const Walk walked = walk(problem, solution.originalTip, outwards / length, length);
  solution.shift = walked.end - solution.originalTip;
  finish(problem, walked, solution);
}

void scaleAboutPivot(const TipProblem& problem, const Vec3& outwards, TipSolution& solution) {
  const double length = glm::length(outwards);
  if (solution.seen) {
    const bool keepsDepth = problem.sight->keepDepth;
    solution.seen = seenWalk(problem, solution.originalTip, outwards / length, length);
    solution.keepsDepth = keepsDepth ? std::optional(problem.sight->camera.forward) : std::nullopt;
    finishSeen(problem, keepsDepth ? glm::length(flattened(problem.sight->camera, outwards)) : length,
               solution);
    return;
  }
  const Walk walked = walk(problem, solution.originalTip, outwards / length, length);
  solution.trailScale = 1.0 + walked.signedDistance / length;
  finish(problem, walked, solution);
}

// How far the path gets from the pivot along the active axes.
double extentOf(const TipProblem& problem, const Vec3& pivotPoint) {
  double extent = 0.0;
  for (const std::vector<Vec3>* points : {&problem.points, &problem.between}) {
    for (const Vec3& point : *points) {
      extent = std::max(extent, glm::length(masked(problem.axes, point - pivotPoint)));
    }
  }
  return extent;
}

// The path along the active axes, with what lies between its points.
std::vector<Vec3> wayOf(const TipProblem& problem) {
  std::vector<Vec3> way;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    way.push_back(masked(problem.axes, problem.points[i]));
    if (i < problem.between.size()) {
      way.push_back(masked(problem.axes, problem.between[i]));
    }
  }
  return way;
}

int farthestFrom(const TipProblem& problem, const Vec3& pivotPoint) {
  const auto farther = [&](const Vec3& a, const Vec3& b) {
    return glm::length(masked(problem.axes, a - pivotPoint)) <
           glm::length(masked(problem.axes, b - pivotPoint));
  };
  return static_cast<int>(std::max_element(problem.points.begin(), problem.points.end(), farther) -
                          problem.points.begin());
}

} // namespace

bool TipSolution::reached() const {
  if (seen) {
    return seen->reached && outcome != TipOutcome::nothingToScale;
  }
  return outcome != TipOutcome::nothingToScale &&
         std::abs(reachedLength - wantedLength) <= reachedTolerance * wantedLength;
}

TipSolution solveTip(const TipProblem& problem) {
  check(!problem.points.empty(), "a path has at least one point");
  const bool pivotAtStart = problem.pivot == Pivot::start;
  TipSolution solution;
  solution.axes = problem.axes;
  solution.pivotPoint = pivotAtStart ? problem.points.front() : problem.points.back();
  solution.originalTip = pivotAtStart ? problem.points.back() : problem.points.front();
  solution.tip = solution.originalTip;
  solution.trailScale = 1.0;
  solution.wantedLength = problem.scale * problem.limbLength;
  solution.reachedLength = glm::length(solution.originalTip - problem.basePosition);
  solution.farthestSample = farthestFrom(problem, solution.pivotPoint);

  solution.base = problem.basePosition;
  if (problem.sight && problem.sight->asSeen) {
    solution.seen.emplace();
  }
  const double extent = extentOf(problem, solution.pivotPoint);
  const bool still = extent < stillness * problem.limbLength || !(extent > 0.0);
  if (still || onlyTrembles(wayOf(problem), extent, problem.limbLength)) {
    solution.outcome = TipOutcome::nothingToScale;
    return solution;
  }
  const Vec3 outwards = masked(problem.axes, solution.originalTip - solution.pivotPoint);
  if (glm::length(outwards) < 0.5 * extent) {
    solution.trailScale.reset();
    moveWhole(problem, solution);
  } else {
    scaleAboutPivot(problem, outwards, solution);
  }
  if (problem.sight && !problem.sight->asSeen && solution.outcome != TipOutcome::nothingToScale) {
    turnToView(problem, solution);
  }
  return solution;
}

Vec3 exaggeratePoint(const TipSolution& solution, const Vec3& point) {
  if (!solution.trailScale) {
    return turned(solution, point + solution.shift);
  }
  Vec3 way = masked(solution.axes, point - solution.pivotPoint);
  if (solution.keepsDepth) {
    way -= *solution.keepsDepth * glm::dot(*solution.keepsDepth, way);
  }
  return turned(solution, point + (*solution.trailScale - 1.0) * way);
}

bool onlyTrembles(const std::vector<Vec3>& points, double extent, double limbLength) {
  constexpr double shortPath = 1e-3; // of the limb: such trembling would be scaled up by the thousands
  constexpr double wandering = 2.0;  // of how far it gets
  return extent < shortPath * limbLength && polylineLength(points) > wandering * extent;
}

std::vector<double> pathRatios(const std::vector<Vec3>& points, const std::vector<double>& timesSeconds,
                               Pivot pivot) {
  check(points.size() == timesSeconds.size() && !points.empty(), "a path has one time for each point");
  std::vector<double> ratios = lengthsAlong(points);
  double whole = ratios.back();
  if (!(whole > 0.0 && std::isfinite(whole))) { // so far away that it cannot be measured, or on the spot
    whole = timesSeconds.back() - timesSeconds.front();
    std::transform(timesSeconds.begin(), timesSeconds.end(), ratios.begin(),
                   [&](double time) { return time - timesSeconds.front(); });
  }
  for (double& ratio : ratios) {
    ratio = whole > 0.0 ? ratio / whole : 1.0;
    ratio = pivot == Pivot::start ? ratio : 1.0 - ratio;
  }
  return ratios;
}

Remap::Remap(RemapKind kind, const Ease& easeIn, const Ease& easeOut) {
  constexpr double nearest = 1e-6; // two points of the curve never share a place
  const double in = std::clamp(easeIn.percent, 0.0, 1.0 - 2 * nearest);
  const double out = std::clamp(easeOut.percent, 0.0, 1.0 - nearest - in);
  points_.emplace_back(0.0, 0.0);
  if (in > nearest) {
    points_.emplace_back(in, std::clamp(easeIn.value, 0.0, 0.5));
  }
  if (out > nearest && 1.0 - out > points_.back().x + nearest / 2) {
    points_.emplace_back(1.0 - out, std::clamp(easeOut.value, 0.5, 1.0));
  }
  points_.emplace_back(1.0, 1.0);
  if (kind == RemapKind::spline) {
    spline_.emplace(points_);
  }
}

double Remap::at(double ratio) const {
  const double r = ratio > 0.0 ? std::min(ratio, 1.0) : 0.0; // 0 for what is no number
  if (spline_) {
    return spline_->at(r);
  }
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (r <= points_[i].x) {
      const double t = (r - points_[i - 1].x) / (points_[i].x - points_[i - 1].x);
      return points_[i - 1].y + t * (points_[i].y - points_[i - 1].y);
    }
  }
  return 1.0;
}

} // namespace stretch::rig

#include "rig/ik/limb_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/math/rotation.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

struct Chain {
  std::vector<Vec3> bones; // vectors from joint to joint
  Vec3 chord{0.0};
  double reach = 0.0;
  double length = 0.0; // sum of the bones'
};

Chain chainOf(const std::vector<Vec3>& points) {
  Chain chain;
  for (std::size_t i = 1; i < points.size(); ++i) {
    chain.bones.push_back(points[i] - points[i - 1]);
    chain.length += glm::length(chain.bones.back());
  }
  chain.chord = points.back() - points.front();
  chain.reach = glm::length(chain.chord);
  return chain;
}

Vec3 unitOr(const Vec3& v, const Vec3& fallback) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : fallback;
}

double clampStretch(double stretch, LimbShape& shape) {
  const double clamped = std::clamp(stretch, smallestStretch, largestStretch);
  if (clamped != stretch) {
    shape.outcome = ShapeOutcome::clamped;
  }
  return clamped;
}

Vec3 bendNormalOf(const LimbShapeProblem& problem, const Chain& chain) {
  if (glm::length(problem.bendNormal) > 0.5) {
    return problem.bendNormal;
  }
  Vec3 normal(0.0);
  for (std::size_t i = 1; i < chain.bones.size(); ++i) {
    normal += glm::cross(chain.bones[i - 1], chain.bones[i]);
  }
  return unitOr(normal, anyPerpendicular(chain.chord));
}

// Rotation about `normal` from the direction of `from` towards that of `to`, both projected on its plane.
double angleInPlane(const Vec3& from, const Vec3& to, const Vec3& normal) {
  const Vec3 a = from - normal * glm::dot(from, normal);
  const Vec3 b = to - normal * glm::dot(to, normal);
  return std::atan2(glm::dot(normal, glm::cross(a, b)), glm::dot(a, b));
}

// Sum of the bones, each turned by its own turn and stretched alike.
Vec3 endVector(const Chain& chain, const std::vector<Quat>& turns, double stretch) {
  Vec3 sum(0.0);
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    sum += turns[i] * chain.bones[i];
  }
  return sum * stretch;
}

// Bones turned in their planes towards the chord: 0 as they are, 1 straight.
std::vector<Quat> uncurled(const Chain& chain, double amount, const Vec3& bendNormal) {
  std::vector<Quat> turns;
  for (const Vec3& bone : chain.bones) {
    const Vec3 axis = unitOr(glm::cross(bone, chain.chord), bendNormal);
    turns.push_back(axisAngle(axis, amount * angleBetween(bone, chain.chord)));
  }
  return turns;
}

// 1 where the limb bends about the normal, -1 where it is bent backwards.
double bendSide(const Chain& chain, const Vec3& bendNormal) {
  double bend = 0.0;
  for (std::size_t i = 1; i < chain.bones.size(); ++i) {
    bend += glm::dot(bendNormal, glm::cross(chain.bones[i - 1], chain.bones[i]));
  }
  return bend < 0.0 ? -1.0 : 1.0;
}

// Bones turned about the bend normal, each further than the one before: 0 as they are, 1 a straight chain of
// equal bones rolled up to a closed ring. Works for a straight chain too, which has no planes of its own.
std::vector<Quat> rolledUp(const Chain& chain, double amount, const Vec3& bendNormal) {
  std::vector<Quat> turns;
  const auto count = static_cast<double>(chain.bones.size());
  const double ring = 2.0 * pi * bendSide(chain, bendNormal);
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    const double place = (static_cast<double>(i) + 0.5) / count - 0.5;
    turns.push_back(axisAngle(bendNormal, amount * ring * place));
  }
  return turns;
}

// How many times as far aside of the chord each bone may point before a joint folds onto itself or a bone
// points back along the chord, and how far the farthest one points aside.
struct Folding {
  double most = 1.0;
  double aside = 0.0;
};

Folding foldingOf(const Chain& chain) {
  constexpr double farthestAside = 120.0 * pi / 180.0;
  constexpr double farthestBend = 165.0 * pi / 180.0;
  Folding folding;
  double bend = 0.0;
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    folding.aside = std::max(folding.aside, angleBetween(chain.bones[i], chain.chord));
    bend = i > 0 ? std::max(bend, angleBetween(chain.bones[i - 1], chain.bones[i])) : bend;
  }
  if (folding.aside > 0.0 && bend > 0.0) {
    folding.most = std::max(1.0, std::min(farthestAside / folding.aside, farthestBend / bend));
  }
  return folding;
}

// 0 as the chain is, 1 as short as it gets: first each joint bends on the way it is bent, then that goes over
// into rolling up; the less clear that way is, the more of it is rolling up from the beginning.
std::vector<Quat> curled(const Chain& chain, double amount, const Vec3& bendNormal) {
  constexpr double clear = 25.0 * pi / 180.0;
  const Folding folding = foldingOf(chain);
  const double own = smoothstep(folding.aside / clear);
  const double fold = own * (1.0 - std::abs(2.0 * amount - 1.0)) * (folding.most - 1.0);
  const double roll = (1.0 - own) * amount + own * std::max(0.0, 2.0 * amount - 1.0);
  std::vector<Quat> turns = uncurled(chain, -fold, bendNormal);
  const std::vector<Quat> rolled = rolledUp(chain, roll, bendNormal);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    turns[i] = rolled[i] * turns[i];
  }
  return turns;
}

// The chain longer or shorter between its ends until it spans `reach`: bisection.
std::vector<Quat> turnsToReach(const Chain& chain, double stretch, double reach, const Vec3& bendNormal) {
  const double now = stretch * chain.reach;
  const bool opens = now < reach;
  const auto turnsAt = [&](double amount) {
    return opens ? uncurled(chain, amount, bendNormal) : curled(chain, amount, bendNormal);
  };
  if (std::abs(now - reach) <= 1e-12 * reach) {
    return turnsAt(0.0);
  }
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const bool shorter = glm::length(endVector(chain, turnsAt(middle), stretch)) < reach;
    (shorter == opens ? low : high) = middle;
  }
  return turnsAt(0.5 * (low + high));
}

// Angle at the base between the first bone and the chord of a triangle with these sides.
double baseAngle(double first, double second, double reach) {
  if (!(first > 0.0) || !(reach > 0.0)) {
    return 0.0;
  }
  return std::acos(
      std::clamp((first * first + reach * reach - second * second) / (2.0 * first * reach), -1.0, 1.0));
}

// Law of cosines: both bones turn about the bend normal by as much as their angles to the chord change.
std::vector<Quat> twoBoneTurns(const Chain& chain, double stretch, double reach, const Vec3& normal) {
  const double first = glm::length(chain.bones[0]);
  const double second = glm::length(chain.bones[1]);
  const double baseBefore = baseAngle(first, second, chain.reach);
  const double endBefore = baseAngle(second, first, chain.reach);
  const double baseAfter = baseAngle(first * stretch, second * stretch, reach);
  const double endAfter = baseAngle(second * stretch, first * stretch, reach);
  const double side = bendSide(chain, normal);
  return {axisAngle(normal, -side * (baseAfter - baseBefore)),
          axisAngle(normal, side * (endAfter - endBefore))};
}

void turnAll(std::vector<Quat>& turns, const Quat& turn) {
  for (Quat& each : turns) {
    each = turn * each;
  }
}

LimbShape keepBend(const LimbShapeProblem& problem, const Chain& chain, const Vec3& toTarget) {
  LimbShape shape;
  // d / d0 - 1, with d0 kept away from 0 in a way that a target where the end is always asks for no stretch.
  const double growth = (glm::length(toTarget) - chain.reach) / std::max(chain.reach, problem.shortestReach);
  shape.stretch = clampStretch(1.0 + problem.stretchSwitch * growth, shape);
  const Quat turn = steadyTurn(chain.chord, toTarget, bendNormalOf(problem, chain));
  shape.turns.assign(chain.bones.size(), turn);
  shape.end = problem.points.front() + turn * chain.chord * shape.stretch;
  return shape;
}

double straightenedStretch(const LimbShapeProblem& problem, const Chain& chain, double distance) {
  double stretch = 1.0 + problem.straightenAmount * (distance / problem.restLength - 1.0);
  if (problem.grows) {
    stretch = std::max(stretch, 1.0);
  }
  // With the switch fully on the hand never leaves the trail.
  return problem.stretchSwitch >= 1.0 ? std::max(stretch, distance / chain.length) : stretch;
}

LimbShape straighten(const LimbShapeProblem& problem, const Chain& chain, const Vec3& toTarget) {
  LimbShape shape;
  const double distance = glm::length(toTarget);
  shape.stretch = clampStretch(straightenedStretch(problem, chain, distance), shape);
  const double reach = std::min(distance, shape.stretch * chain.length);
  const Vec3 normal = bendNormalOf(problem, chain);
  shape.turns = chain.bones.size() == 2 ? twoBoneTurns(chain, shape.stretch, reach, normal)
                                        : turnsToReach(chain, shape.stretch, reach, normal);
  turnAll(shape.turns, steadyTurn(chain.chord, toTarget, normal));
  // The limb's end is now as far as wanted; what the bend plane left of its direction is turned away.
  turnAll(shape.turns, shortestArc(endVector(chain, shape.turns, shape.stretch), toTarget));
  shape.end = problem.points.front() + endVector(chain, shape.turns, shape.stretch);
  return shape;
}

} // namespace

bool LimbShape::isIdentity() const {
  const auto still = [](const Quat& turn) { return turn.x == 0.0 && turn.y == 0.0 && turn.z == 0.0; };
  return stretch == 1.0 && std::all_of(turns.begin(), turns.end(), still);
}

Quat steadyTurn(const Vec3& from, const Vec3& to, const Vec3& normal) {
  constexpr double blendStart = 150.0 * pi / 180.0;
  constexpr double blendEnd = 170.0 * pi / 180.0;
  const Quat smallest = shortestArc(from, to);
  const double angle = angleBetween(from, to);
  if (angle <= blendStart) {
    return smallest;
  }
  const Quat inPlane = axisAngle(normal, angleInPlane(from, to, normal));
  const Quat planar = shortestArc(inPlane * from, to) * inPlane;
  const Quat blended =
      glm::slerp(smallest, planar, smoothstep((angle - blendStart) / (blendEnd - blendStart)));
  return glm::normalize(shortestArc(blended * from, to) * blended);
}

LimbShape solveLimbShape(const LimbShapeProblem& problem) {
  check(problem.points.size() >= 2, "a limb has a base and an end");
  const Chain chain = chainOf(problem.points);
  const Vec3 toTarget = problem.target - problem.points.front();
  const bool straightens = problem.bend == Bend::straighten;
  if (!(chain.reach > 0.0) || !(chain.length > 0.0) || (straightens && !(problem.restLength > 0.0))) {
    LimbShape still;
    still.turns.assign(chain.bones.size(), Quat(1.0, 0.0, 0.0, 0.0));
    still.end = problem.points.back();
    still.outcome = ShapeOutcome::degenerate;
    return still;
  }
  // One bone has no bend to straighten.
  const bool bends = chain.bones.size() > 1;
  return straightens && bends ? straighten(problem, chain, toTarget) : keepBend(problem, chain, toTarget);
}

} // namespace stretch::rig

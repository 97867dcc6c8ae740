#include "rig/retarget/joined_hands.h"

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/limb.h"
#include "rig/trail/release.h"

namespace stretch::rig {

std::optional<double> shoulderWidth(const Skeleton& skeleton) {
  constexpr double least = 1e-3; // of the height
  if (!skeleton.arms[leftSide] || !skeleton.arms[rightSide]) {
    return std::nullopt;
  }
  const auto base = [&](std::size_t side) {
    return positionOf(skeleton.bind[at(skeleton.arms[side]->limb.joints.front())]);
  };
  const double width = glm::length(base(leftSide) - base(rightSide));
  return width > least * skeleton.height ? std::optional(width) : std::nullopt;
}

JoinedHands joinedHands(const Skeleton& skeleton, const std::vector<Mat4>& worlds, double width) {
  constexpr double apartAt = 1.15; // wrists against elbows
  constexpr double degree = pi / 180.0;
  constexpr double hanging = 20.0 * degree; // between the way to the hands and the way down the trunk
  constexpr double raised = 35.0 * degree;
  const std::vector<Vec3> left = limbPoints(skeleton.arms[leftSide]->limb, worlds);
  const std::vector<Vec3> right = limbPoints(skeleton.arms[rightSide]->limb, worlds);
  JoinedHands hands;
  hands.leftToRight = (right.back() - left.back()) / width;
  const double elbows = glm::length(right[1] - left[1]);
  const Vec3 shoulders = 0.5 * (left.front() + right.front());
  const Vec3 hips = 0.5 * (positionOf(worlds[at(skeleton.legs[leftSide].limb.joints.front())]) +
                           positionOf(worlds[at(skeleton.legs[rightSide].limb.joints.front())]));
  const Vec3 toHands = 0.5 * (left.back() + right.back()) - shoulders;
  if (left.size() < 3 || right.size() < 3 || !(elbows > 0.0)) {
    return hands;
  }
  const double ratio = width * glm::length(hands.leftToRight) / elbows;
  const double angle = angleBetween(toHands, hips - shoulders);
  hands.share = (1.0 - smoothstep((ratio - 1.0) / (apartAt - 1.0))) *
                smoothstep((angle - hanging) / (raised - hanging));
  return hands;
}

Vec3 middleInReach(const std::array<Ball, 2>& balls, const Vec3& wanted) {
  constexpr int turns = 32;
  Vec3 place = wanted;
  for (int turn = 0; turn < turns; ++turn) {
    for (const Ball& ball : balls) {
      const Vec3 out = place - ball.centre;
      const double far = glm::length(out);
      place = far > ball.radius ? ball.centre + out * (ball.radius / far) : place;
    }
  }
  return place;
}

} // namespace stretch::rig

#include "rig/motion/best_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"

namespace stretch::rig {

namespace {

constexpr double degree = pi / 180.0;

Vec3 acrossView(const Vec3& eye, const Vec3& v) {
  return v - eye * glm::dot(eye, v);
}

// Of a length: what is left of it in the picture; 0 without a length.
double share(double seen, double whole) {
  return whole > 0.0 ? seen / whole : 0.0;
}

double pathShare(const SightedAction& action, const Vec3& eye) {
  std::vector<Vec3> seen;
  for (const Vec3& point : action.path) {
    seen.push_back(acrossView(eye, point));
  }
  return share(polylineLength(seen), polylineLength(action.path));
}

// Whether the trunk, a thick line, is between a point and the eye.
bool isHidden(const SightedAction& action, const Vec3& eye, const Vec3& point) {
  const Vec3 trunk = action.trunkHigh - action.trunkLow;
  const Vec3 flatTrunk = acrossView(eye, trunk);
  const Vec3 flatWay = acrossView(eye, point - action.trunkLow);
  const double squared = glm::dot(flatTrunk, flatTrunk);
  const double along = squared > 0.0 ? std::clamp(glm::dot(flatWay, flatTrunk) / squared, 0.0, 1.0) : 0.0;
  const Vec3 onTrunk = action.trunkLow + along * trunk;
  return glm::length(acrossView(eye, point - onTrunk)) < action.trunkRadius &&
         glm::dot(eye, onTrunk - point) > 0.0;
}

double hiddenShare(const SightedAction& action, const Vec3& eye) {
  const auto hidden =
      std::ranges::count_if(action.path, [&](const Vec3& point) { return isHidden(action, eye, point); });
  return share(static_cast<double>(hidden), static_cast<double>(action.path.size()));
}

// How well the action is seen: 2 for path and limb in full length, less what an animator would not like.
double worth(const SightedAction& action, const Vec3& eye) {
  constexpr double profile = 0.15; // the face is turned away beyond a profile, nearly
  const Vec3 limb = action.tip - action.base;
  const double seen = pathShare(action, eye) + share(glm::length(acrossView(eye, limb)), glm::length(limb));
  const double face = action.facing ? glm::dot(*action.facing, eye) : profile;
  const double turnedAway = face < profile ? 1.0 + profile - face : 0.0;
  const double level = std::abs(eye.y - std::sin(5.0 * degree));
  return seen - turnedAway + 0.1 * face - 0.5 * hiddenShare(action, eye) - 0.2 * level;
}

} // namespace

Vec3 bestView(const SightedAction& action) {
  Vec3 best(0.0, 0.0, 1.0);
  double most = -1e300;
  for (int pitch = -15; pitch <= 40; pitch += 5) {
    for (int yaw = -180; yaw < 180; yaw += 5) {
      const double up = pitch * degree;
      const double round = yaw * degree;
      const Vec3 eye(std::cos(up) * std::sin(round), std::sin(up), std::cos(up) * std::cos(round));
      const double value = worth(action, eye);
      if (value > most + 1e-9) {
        most = value;
        best = eye;
      }
    }
  }
  return best;
}

} // namespace stretch::rig

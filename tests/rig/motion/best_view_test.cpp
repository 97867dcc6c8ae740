// The best view of actions drawn by chance, against looking from every place of the grid at a picture.
#include "rig/motion/best_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

using namespace stretch;
using namespace stretch::rig;

namespace {

constexpr double oneDegree = pi / 180.0;

/// A picture as it is drawn: right and up in it, and how near the eye a point is.
struct Picture {
  Vec3 right{0.0};
  Vec3 up{0.0};
  Vec3 near{0.0};

  Picture(int pitch, int yaw) {
    const double a = pitch * oneDegree;
    const double b = yaw * oneDegree;
    right = {std::cos(b), 0.0, -std::sin(b)};
    near = {std::cos(a) * std::sin(b), std::sin(a), std::cos(a) * std::cos(b)};
    up = glm::cross(near, right);
  }
  Vec2 drawn(const Vec3& v) const { return {glm::dot(v, right), glm::dot(v, up)}; }
};

double ratio(double part, double whole) {
  return whole == 0.0 ? 0.0 : part / whole;
}

/// Whether the point lies behind the trunk as it is drawn: the nearest point of the line in the picture.
bool isBehindTrunk(const SightedAction& action, const Picture& picture, const Vec3& point) {
  const Vec2 low = picture.drawn(action.trunkLow);
  const Vec2 line = picture.drawn(action.trunkHigh) - low;
  const Vec2 way = picture.drawn(point) - low;
  const double square = line.x * line.x + line.y * line.y;
  double along = square > 0.0 ? (way.x * line.x + way.y * line.y) / square : 0.0;
  along = along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along;
  const Vec3 nearest = (1.0 - along) * action.trunkLow + along * action.trunkHigh;
  return glm::length(picture.drawn(point) - picture.drawn(nearest)) < action.trunkRadius &&
         glm::dot(picture.near, point) < glm::dot(picture.near, nearest);
}

/// How well the picture shows the action: lengths that are left in it, a tenth of how far the face looks at
/// the eye, less half of what the trunk hides, all of what the face is turned away from nearly a profile, and
/// a fifth of what the eye is off five degrees above level.
double shownIn(const SightedAction& action, const Picture& picture) {
  double seen = 0.0;
  double whole = 0.0;
  double hidden = 0.0;
  for (std::size_t i = 0; i < action.path.size(); ++i) {
    hidden += isBehindTrunk(action, picture, action.path[i]) ? 1.0 : 0.0;
    if (i + 1 < action.path.size()) {
      seen += glm::length(picture.drawn(action.path[i + 1] - action.path[i]));
      whole += glm::length(action.path[i + 1] - action.path[i]);
    }
  }
  const Vec3 limb = action.tip - action.base;
  double value = ratio(seen, whole) + ratio(glm::length(picture.drawn(limb)), glm::length(limb));
  const double face = action.facing ? glm::dot(*action.facing, picture.near) : 0.15;
  value += 0.1 * face - (face < 0.15 ? 1.15 - face : 0.0);
  value -= 0.5 * ratio(hidden, static_cast<double>(action.path.size()));
  return value - 0.2 * std::abs(picture.near.y - std::sin(5.0 * oneDegree));
}

/// The first of the best by looking from all of them; nothing where two are hardly different.
std::optional<Vec3> lookedFor(const SightedAction& action) {
  struct Look {
    double value;
    Vec3 eye;
  };
  std::vector<Look> looks;
  for (int pitch = -15; pitch <= 40; pitch += 5) {
    for (int yaw = -180; yaw < 180; yaw += 5) {
      const Picture picture(pitch, yaw);
      looks.push_back({shownIn(action, picture), picture.near});
    }
  }
  std::ranges::stable_sort(looks, [](const Look& a, const Look& b) { return a.value > b.value; });
  return looks[0].value - looks[1].value > 1e-6 ? std::optional(looks[0].eye) : std::nullopt;
}

SightedAction drawnAction(std::mt19937& chance) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto place = [&] { return Vec3(number(chance), number(chance), number(chance)); };
  SightedAction action;
  const Vec3 way = place();
  const Vec3 from = 0.6 * place();
  const auto points = static_cast<int>(chance() % 9U);
  for (int i = 0; i < points; ++i) {
    action.path.push_back(from + static_cast<double>(i) / 8.0 * way + 0.1 * place());
  }
  action.base = 0.3 * place();
  action.tip = chance() % 6U == 0 ? action.base : action.path.empty() ? place() : action.path.back();
  action.trunkLow = 0.4 * place();
  action.trunkHigh = chance() % 6U == 0 ? action.trunkLow : action.trunkLow + 0.8 * place();
  action.trunkRadius = chance() % 3U == 0 ? 0.0 : 0.25 * (1.0 + number(chance));
  if (chance() % 3U != 0) {
    action.facing = glm::normalize(place());
  }
  return action;
}

} // namespace

TEST_CASE("The best view is the first of those that show the most, of one each five degrees", "[best-view]") {
  std::mt19937 chance(7);
  int clear = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const SightedAction action = drawnAction(chance);
    if (const std::optional<Vec3> eye = lookedFor(action)) {
      ++clear;
      CHECK(glm::distance(bestView(action), *eye) < 1e-9);
    }
  }
  CHECK(clear > 40);
}

TEST_CASE("Of views that show the same the one farthest below and round from behind is taken",
          "[best-view]") {
  // Nothing to see, no face: level alone counts, from all sides.
  const Vec3 eye = bestView({});
  CHECK(eye.y == Approx(std::sin(5.0 * oneDegree)));
  CHECK(eye.z == Approx(-std::cos(5.0 * oneDegree)));
  CHECK(eye.x == Approx(0.0).margin(1e-12));
}

TEST_CASE("A trunk hides what is behind it alone, and no more than its radius beside it", "[best-view]") {
  SightedAction punch; // towards the right, on one side of the trunk
  punch.path = {Vec3(-0.5, 1.2, 0.0), Vec3(0.5, 1.2, 0.0)};
  punch.base = Vec3(0.0, 1.2, -0.1);
  punch.tip = Vec3(0.5, 1.2, -0.1);
  punch.trunkRadius = 0.6;
  const double behind = GENERATE(-0.3, 0.3);
  punch.trunkLow = Vec3(0.0, 0.6, behind);
  punch.trunkHigh = Vec3(0.0, 1.6, behind);
  CHECK(bestView(punch).z * behind < 0.0);
}

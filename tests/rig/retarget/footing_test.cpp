#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/retarget/footing.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

constexpr double legLength = 1.0;
constexpr std::size_t count = 40;

std::vector<double> seconds() {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(static_cast<double>(i) / 24.0);
  }
  return times;
}

// Steps from one place to another between frames 12 and 20.
std::vector<Vec3> stepping(double from, double to) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = i <= 12 ? 0.0 : i >= 20 ? 1.0 : static_cast<double>(i - 12) / 8.0;
    places.emplace_back(0.0, 0.0, from + share * (to - from));
  }
  return places;
}

// A foot that is 0.1 longer than the source's, which turns by a quarter while it stands on its ball, frames
// 22 to 32.
FootMotion turningFoot() {
  FootMotion foot;
  foot.balls = stepping(0.0, 0.6);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = i < 22 ? 0.0 : i > 32 ? 1.0 : static_cast<double>(i - 22) / 10.0;
    const Vec3 back(-std::sin(0.5 * pi * turn), 0.0, -std::cos(0.5 * pi * turn));
    foot.ankles.push_back(foot.balls[i] + 0.2 * back);
    foot.toAnkle.push_back(0.3 * back);
    foot.wanted.push_back(foot.ankles[i] + Vec3(0.05, 0.0, 0.0));
  }
  foot.ankleStands = standsOf(foot.ankles, seconds(), legLength);
  foot.ballStands = standsOf(foot.balls, seconds(), legLength);
  return foot;
}

} // namespace

TEST_CASE("A foot rests where it keeps its place for a while, and not while it steps") {
  const std::vector<Stand> stands = standsOf(stepping(0.0, 0.6), seconds(), legLength);
  REQUIRE(stands.size() == 2);
  CHECK(stands[0].first == 0);
  CHECK(stands[0].last == 12);
  CHECK(stands[1].first == 20);
  CHECK(stands[1].last == count - 1);
}

TEST_CASE("A foot that stops for three frames stands, and one that stops for two does not") {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double way = i < 10 ? static_cast<double>(i) : i < 12 ? 10.0 : static_cast<double>(i) - 1.0;
    places.emplace_back(0.0, 0.0, 0.1 * way);
  }
  CHECK(standsOf(places, seconds(), legLength).empty());
  for (std::size_t i = 12; i < count; ++i) {
    places[i].z -= 0.1;
  }
  const std::vector<Stand> stands = standsOf(places, seconds(), legLength);
  REQUIRE(stands.size() == 1);
  CHECK(stands.front().first == 10);
  CHECK(stands.front().last == 12);
}

TEST_CASE("A foot that only shuffles between two stands goes as the source's does, whatever the body does") {
  FootMotion foot;
  for (std::size_t i = 0; i < count; ++i) {
    foot.ankles.emplace_back(0.0, 0.0, i < 20 ? 0.0 : 0.02);
    foot.balls.push_back(foot.ankles[i] + Vec3(0.0, 0.0, 0.2));
    foot.toAnkle.emplace_back(0.0, 0.0, -0.3);
    foot.wanted.emplace_back(i < 20 ? 0.0 : 0.3, 0.0, foot.ankles[i].z);
  }
  foot.ankleStands = {{0, 19}, {20, count - 1}};
  foot.ballStands = foot.ankleStands;
  foot.ankleStands.front().last = foot.ballStands.front().last = 18;
  foot.shuffle = 0.1;
  const std::vector<Vec3> ankles = plantedAnkles(foot);
  for (std::size_t i = 1; i < count; ++i) {
    CHECK(glm::length(ankles[i] - ankles[i - 1] - (foot.ankles[i] - foot.ankles[i - 1])) < 1e-9);
  }
  foot.shuffle = 0.01; // now it was a step: each stand is where the leg has it
  const std::vector<Vec3> stepped = plantedAnkles(foot);
  CHECK(stepped.front().x == Approx(0.0).margin(1e-9));
  CHECK(stepped.back().x == Approx(0.3));
}

TEST_CASE("A heel stands until the ball does, without a slip in the frame between them") {
  FootMotion foot;
  for (std::size_t i = 0; i < count; ++i) {
    foot.ankles.emplace_back(0.0);
    foot.balls.emplace_back(0.0, 0.0, 0.2);
    foot.toAnkle.emplace_back(0.0, 0.0, -0.3);
    foot.wanted.emplace_back(0.0, 0.0, 0.01 * static_cast<double>(i));
  }
  foot.ankleStands = {{0, 19}};
  foot.ballStands = {{20, count - 1}};
  const std::vector<Vec3> ankles = plantedAnkles(foot);
  for (const Vec3& ankle : ankles) {
    CHECK(glm::length(ankle - ankles.front()) < 1e-9);
  }
}

TEST_CASE(
    "A heel that stands quite still keeps its place while the ball of a longer foot turns slowly about it") {
  // Over all frames heel and ball are slow enough to stand; the heel alone keeps its place.
  FootMotion foot;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 0.01 * static_cast<double>(i);
    const Vec3 forward(std::sin(turn), 0.0, std::cos(turn));
    foot.ankles.emplace_back(0.0);
    foot.balls.push_back(0.2 * forward);
    foot.toAnkle.push_back(-0.3 * forward);
    foot.wanted.emplace_back(0.0, 0.0, 0.01 * static_cast<double>(i));
  }
  foot.ankleStands = foot.ballStands = foot.heldAnkles = {{0, count - 1}};
  const auto wander = [](const std::vector<Vec3>& places) { return wanderIn(places, {0, count - 1}); };
  CHECK(wander(plantedAnkles(foot)) < 1e-9);
  // The ball where it is the ball that does, and where both do.
  const auto ballsOf = [&](const std::vector<Vec3>& ankles) {
    std::vector<Vec3> balls;
    for (std::size_t i = 0; i < count; ++i) {
      balls.push_back(ankles[i] - foot.toAnkle[i]);
    }
    return balls;
  };
  foot.heldBalls = foot.heldAnkles;
  foot.balls.assign(count, Vec3(0.0, 0.0, 0.2));
  CHECK(wander(ballsOf(plantedAnkles(foot))) < 1e-9);
  foot.heldAnkles.clear();
  CHECK(wander(ballsOf(plantedAnkles(foot))) < 1e-9);
}

TEST_CASE("A ball of the foot that stands in the source stands, while a longer foot turns about it") {
  const FootMotion foot = turningFoot();
  const std::vector<Vec3> ankles = plantedAnkles(foot);
  const auto ball = [&](std::size_t i) { return ankles[i] - foot.toAnkle[i]; };
  for (std::size_t i = 0; i <= 12; ++i) {
    CHECK(glm::length(ball(i) - ball(0)) < 1e-9);
  }
  for (std::size_t i = 20; i < count; ++i) {
    CHECK(glm::length(ball(i) - ball(20)) < 1e-9);
  }
}

TEST_CASE("A foot that stands is on the mean where the leg would have it, and goes there without a jump") {
  const FootMotion foot = turningFoot();
  const std::vector<Vec3> ankles = plantedAnkles(foot);
  Vec3 apart(0.0);
  for (std::size_t i = 20; i < count; ++i) {
    apart += ankles[i] - foot.wanted[i];
  }
  CHECK(glm::length(apart) < 1e-9);
  for (std::size_t i = 1; i < count; ++i) {
    CHECK(glm::length(ankles[i] - ankles[i - 1]) < 0.12);
  }
}

TEST_CASE("A foot that never stands goes where the leg has it") {
  FootMotion foot = turningFoot();
  foot.ankleStands.clear();
  foot.ballStands.clear();
  CHECK(plantedAnkles(foot) == foot.wanted);
}

TEST_CASE("The body comes down as far as it has to, and not at once") {
  std::vector<double> needed(count, 0.0);
  needed[20] = 0.1;
  const std::vector<double> eased = easedAbove(needed, 3);
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(eased[i] >= needed[i] - 1e-12);
  }
  CHECK(eased[20] == Approx(0.1));
  CHECK(eased[16] > 0.0);
  CHECK(eased[16] < 0.1);
  CHECK(eased[5] == 0.0);
}

#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/retarget/standing.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

constexpr double height = 2.0;
constexpr double rate = 25.0;

// Stands still for `still` frames, `up` above the floor, then goes on by 0.1 in each frame along the floor.
std::vector<Vec3> stopping(std::size_t still, double up) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < still; ++i) {
    places.emplace_back(0.0, up, 0.0);
  }
  for (std::size_t i = 1; i < 6; ++i) {
    places.emplace_back(0.1 * static_cast<double>(i), 0.0, 0.0);
  }
  return places;
}

} // namespace

TEST_CASE("A foot stands that is low and still for three frames") {
  const std::vector<Stand> stands = standingIn(stopping(3, 0.0), rate, height);
  REQUIRE(stands.size() == 1);
  CHECK(stands.front().first == 0);
  CHECK(stands.front().last == 2);
  CHECK(standingIn(stopping(2, 0.0), rate, height).empty());
  CHECK(standingIn(stopping(5, 0.015), rate, height).size() == 1);
  CHECK(standingIn(stopping(5, 0.025), rate, height).empty()); // 1 % of the height above its lowest
  CHECK(standingIn({}, rate, height).empty());
}

TEST_CASE("A foot that is set down slowly stands from where it is low") {
  std::vector<Vec3> places;
  for (const double up : {0.0215, 0.0195, 0.0175, 0.0155}) { // low is what lies less than 0.02 up
    places.emplace_back(0.0, up, 0.0);
  }
  for (std::size_t i = 1; i < 6; ++i) {
    places.emplace_back(0.1 * static_cast<double>(i), 0.0, 0.0);
  }
  const std::vector<Stand> stands = standingIn(places, rate, height);
  REQUIRE(stands.size() == 1);
  CHECK(stands.front().first == 1);
  CHECK(stands.front().last == 3);
}

TEST_CASE("A foot that goes faster than a twentieth of the height in each second does not stand") {
  const auto going = [](double speed) {
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < 10; ++i) {
      places.emplace_back(speed * static_cast<double>(i) / rate, 0.0, 0.0);
    }
    return standingIn(places, rate, height);
  };
  CHECK(going(0.09).size() == 1);
  CHECK(going(0.11).empty());
}

TEST_CASE("A foot wanders as far as it gets from its first place") {
  const std::vector<Vec3> places{
      {5.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.3}, {0.0, 0.0, 0.1}, {9.0, 0.0, 0.0}};
  CHECK(wanderIn(places, {1, 3}) == Approx(0.3));
}

TEST_CASE("A foot that is held keeps the middle of its places, and goes over to the next without a jump") {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < 30; ++i) {
    places.emplace_back(0.01 * static_cast<double>(i), 0.0, 1.0);
  }
  const std::vector<Vec3> held = heldInPlace(places, {{4, 8}, {20, 24}});
  for (std::size_t i = 0; i < 30; ++i) {
    const bool isFirst = i >= 4 && i <= 8;
    const bool isSecond = i >= 20 && i <= 24;
    if (isFirst || isSecond) {
      CHECK(glm::length(held[i] - Vec3(isFirst ? 0.06 : 0.22, 0.0, 1.0)) < 1e-12);
    }
  }
  for (std::size_t i = 1; i < 30; ++i) {
    CHECK(held[i].x >= held[i - 1].x - 1e-12);
    CHECK(held[i].x - held[i - 1].x < 0.02);
  }
  CHECK(held.front().x == Approx(0.02)); // as far off as where it first stands
  CHECK(held.back().x == Approx(0.27));
  CHECK(heldInPlace(places, {}) == places);
}

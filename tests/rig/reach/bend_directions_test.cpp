#include "rig/reach/bend_directions.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

using namespace stretch;
using namespace stretch::rig;

namespace {

const Quat unturned(1.0, 0.0, 0.0, 0.0);

// A limb of length 2 along y whose joint stands out by `out`.
void addBent(BendDirections& bends, double seconds, const Vec3& out) {
  bends.add(seconds, Vec3(0.0), Vec3(0.0, 1.0, 0.0) + out, Vec3(0.0, 2.0, 0.0), unturned);
}

} // namespace

TEST_CASE("a nearly straight limb bends as it does at the nearest time at which it bends") {
  BendDirections bends(Vec3(0.0, 0.0, -1.0));
  addBent(bends, 1.0, {0.5, 0.0, 0.0});
  addBent(bends, 2.0, {0.001, 0.0, -0.001}); // nearly straight: says nothing
  addBent(bends, 3.0, {0.0, 0.0, 0.5});
  CHECK(glm::length(bends.at(0.0) - Vec3(1.0, 0.0, 0.0)) < 1e-12);
  CHECK(glm::length(bends.at(9.0) - Vec3(0.0, 0.0, 1.0)) < 1e-12);
  CHECK(bends.at(1.2).x > bends.at(1.2).z);
  CHECK(bends.at(2.8).z > bends.at(2.8).x);
}

TEST_CASE("the direction of a bend does not jump in time") {
  BendDirections bends;
  addBent(bends, 1.0, {0.5, 0.0, 0.0});
  addBent(bends, 2.0, {-0.3, 0.0, 0.4});
  for (double seconds = 0.5; seconds < 2.5; seconds += 0.01) {
    CHECK(glm::length(bends.at(seconds + 0.01) - bends.at(seconds)) < 0.05);
  }
}

TEST_CASE("a limb that never bends bends as it is told") {
  const BendDirections bends(Vec3(0.0, 0.0, -1.0));
  CHECK(bends.at(1.0) == Vec3(0.0, 0.0, -1.0));
}

TEST_CASE("a knee that the clip overextends a little bends as it does where it bends clearly") {
  BendDirections bends(Vec3(0.0, 0.0, 1.0));
  addBent(bends, 1.0, {0.0, 0.0, 0.4});
  addBent(bends, 2.0, {0.0, 0.0, -0.07}); // overextended
  addBent(bends, 3.0, {0.06, 0.0, 0.02}); // as much sideways as bent
  addBent(bends, 4.0, {0.0, 0.0, 0.4});
  bends.keepClear();
  for (double seconds = 0.0; seconds < 5.0; seconds += 0.25) {
    CHECK(glm::length(bends.at(seconds) - Vec3(0.0, 0.0, 1.0)) < 1e-12);
  }
}

TEST_CASE("a knee bent the other way by less than an eighth of the leg is overextended, one bent farther is "
          "bent so") {
  const auto bentBack = [](double out) {
    BendDirections bends(Vec3(0.0, 0.0, 1.0));
    addBent(bends, 1.0, {0.0, 0.0, 0.5});
    addBent(bends, 2.0, {0.0, 0.0, -out});
    addBent(bends, 3.0, {0.0, 0.0, 0.5});
    bends.keepClear();
    return bends.at(2.0).z;
  };
  CHECK(bentBack(0.12) > 0.999); // 0.06 of the leg
  CHECK(bentBack(0.18) > 0.999);
  CHECK(bentBack(0.24) > 0.999);  // 0.117 of it
  CHECK(bentBack(0.30) < -0.999); // 0.144 of it
}

TEST_CASE("a limb that is only ever overextended bends as it is told, one that bends that way as it does") {
  BendDirections over(Vec3(0.0, 0.0, 1.0));
  addBent(over, 1.0, {0.0, 0.0, -0.07});
  over.keepClear();
  CHECK(over.at(1.0).z == 1.0);
  BendDirections bird(Vec3(0.0, 0.0, 1.0));
  addBent(bird, 1.0, {0.0, 0.0, -0.6});
  addBent(bird, 2.0, {0.0, 0.0, -0.07});
  bird.keepClear();
  CHECK(bird.at(2.0).z == -1.0);
}

TEST_CASE("legs that lean inwards and never bend clearly bend forwards") {
  BendDirections bends(Vec3(0.0, 0.0, 1.0));
  addBent(bends, 1.0, {0.05, 0.0, 0.0});
  addBent(bends, 2.0, {0.05, 0.0, 0.0});
  bends.keepClear();
  CHECK(bends.at(1.0).z > 0.9);
  CHECK(bends.at(1.0).x > 0.1);
}

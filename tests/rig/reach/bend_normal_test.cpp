#include "rig/reach/bend_normal.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

// Two bones in a plane that turns with the base; bent about `base * z`.
std::vector<Vec3> arm(double bendRadians, const Quat& base) {
  const Vec3 elbow = base * Vec3(1, 0, 0);
  return {Vec3(0.0), elbow, elbow + base * Vec3(std::cos(bendRadians), std::sin(bendRadians), 0)};
}

const Quat upright(1, 0, 0, 0);

} // namespace

TEST_CASE("the bend's normal is the axis about which the elbow bends, and turns with the base") {
  BendNormal normal;
  normal.add(arm(0.8, upright), upright);
  for (const double degrees : {0.0, 70.0, 160.0, 250.0}) {
    const Quat base = axisAngle(glm::normalize(Vec3(1, 1, 0)), degrees * pi / 180.0);
    CHECK(glm::length(normal.at(arm(0.5, base), base) - base * Vec3(0, 0, 1)) < 1e-12);
  }
}

TEST_CASE("through the straight pose and into a backward bend the normal stays where it was") {
  BendNormal normal;
  for (double bend = 0.0; bend < 1.0; bend += 0.1) {
    normal.add(arm(bend, upright), upright);
  }
  for (double bend = 0.5; bend > -0.3; bend -= 0.01) {
    CHECK(glm::length(normal.at(arm(bend, upright), upright) - Vec3(0, 0, 1)) < 1e-9);
  }
}

TEST_CASE("a limb that never bends has no normal") {
  BendNormal normal;
  normal.add(arm(0.0, upright), upright);
  CHECK(normal.at(arm(0.0, upright), upright) == Vec3(0.0));
}

TEST_CASE("points that fall together leave the normal finite") {
  BendNormal normal;
  normal.add({Vec3(1.0), Vec3(1.0), Vec3(1.0)}, upright);
  normal.add(arm(0.8, upright), upright);
  CHECK(glm::length(normal.at({Vec3(1.0), Vec3(1.0), Vec3(1.0)}, upright) - Vec3(0, 0, 1)) < 1e-12);
}

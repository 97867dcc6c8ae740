#include "rig/ik/two_bone.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/math/rotation.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

// A leg of length 1 that hangs from (0, 1, 0), its knee `forward` before its line and `aside` beside it.
TwoBoneProblem hangingLeg(double forward, double aside) {
  TwoBoneProblem leg;
  leg.base = Vec3(0.0, 1.0, 0.0);
  leg.joint = Vec3(aside, 0.5, forward);
  leg.end = Vec3(0.0);
  leg.target = leg.end;
  leg.usualBend = Vec3(0.0, 0.0, 1.0);
  return leg;
}

double degreesBetween(const Quat& a, const Quat& b) {
  return glm::degrees(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))));
}

} // namespace

TEST_CASE("A knee that goes through straight and a little backwards does not turn the leg about itself") {
  // The foot is 8 % nearer than in the pose, so the knee bends clearly in the answer, whatever it does in the
  // pose.
  for (const double aside : {0.0, 0.001, -0.004}) {
    std::optional<TwoBoneShape> before;
    for (int step = 0; step <= 60; ++step) {
      TwoBoneProblem leg = hangingLeg(0.04 - 0.001 * step, aside);
      leg.target = Vec3(0.0, 0.08, 0.0);
      const TwoBoneShape shape = solveTwoBone(leg);
      CAPTURE(aside, step);
      CHECK(shape.joint.z > 0.15);
      if (before) {
        CHECK(degreesBetween(shape.turns[0], before->turns[0]) < 1.0);
        CHECK(degreesBetween(shape.turns[1], before->turns[1]) < 1.0);
      }
      before = shape;
    }
  }
}

TEST_CASE("Bones that are bent in their own plane turn in it alone") {
  for (const double forward : {0.1, 0.03, 0.005, -0.005, -0.015}) {
    TwoBoneProblem leg = hangingLeg(forward, 0.0);
    leg.target = Vec3(0.0, 0.08, 0.0);
    const TwoBoneShape shape = solveTwoBone(leg);
    CAPTURE(forward);
    for (const Quat& turn : shape.turns) {
      const Vec3 axis = turn * Vec3(1.0, 0.0, 0.0);
      CHECK(glm::length(axis - Vec3(1.0, 0.0, 0.0)) < 1e-9);
    }
  }
}

#include "rig/ik/two_bone.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

TEST_CASE("A limb that is folded as tightly as nothing folds by itself keeps its bones as it is turned") {
  TwoBoneProblem leg;
  leg.base = Vec3(0.0, 1.0, 0.0);
  leg.joint = Vec3(0.0, 0.5, 0.0);
  leg.end = Vec3(0.0, 0.99, 0.0); // 0.01 from the base, of 0.99 of bones
  leg.usualBend = Vec3(0.0, 0.0, 1.0);
  leg.target = leg.base + 0.01 * glm::normalize(Vec3(1.0, -3.0, 0.5));
  const TwoBoneShape turned = solveTwoBone(leg);
  CHECK(turned.scale == Approx(1.0).epsilon(1e-9));
  CHECK(glm::length(turned.end - leg.target) < 1e-9);
  CHECK(glm::length(turned.joint - leg.base) == Approx(0.5).epsilon(1e-9));
  leg.target = leg.base - Vec3(0.0, 0.005, 0.0);
  CHECK(solveTwoBone(leg).scale == Approx(0.5).epsilon(1e-9)); // nearer than the pose: it shrinks
}

namespace {

// How much the knee of a straight leg accelerates, in accelerations of its foot, which rises by 12 % of the
// leg's length in 12 frames; and how long the bones get.
struct Pop {
  double ratio = 0.0;
  double longest = 0.0;
};

Pop popOf(double softness) {
  std::vector<Vec3> knees;
  std::vector<Vec3> feet;
  Pop pop;
  for (int frame = -2; frame <= 14; ++frame) {
    TwoBoneProblem leg = hangingLeg(0.0, 0.0);
    const double share = std::clamp(frame / 12.0, 0.0, 1.0);
    leg.target.y = 0.12 * share * share * (3.0 - 2.0 * share);
    leg.softness = softness;
    const TwoBoneShape shape = solveTwoBone(leg);
    CHECK(glm::length(shape.end - leg.target) < 1e-9);
    pop.longest = std::max(pop.longest, shape.scale);
    knees.push_back(shape.joint);
    feet.push_back(shape.end);
  }
  const auto fastest = [](const std::vector<Vec3>& places) {
    double most = 0.0;
    for (std::size_t i = 2; i < places.size(); ++i) {
      most = std::max(most, glm::length(places[i] - 2.0 * places[i - 1] + places[i - 2]));
    }
    return most;
  };
  pop.ratio = fastest(knees) / fastest(feet);
  return pop;
}

} // namespace

TEST_CASE("Softness halves the pop of a straight knee and lengthens the bones by three hundredths at most") {
  const Pop hard = popOf(0.0);
  const Pop soft = popOf(0.2);
  CHECK(hard.ratio > 8.0);
  CHECK(soft.ratio < 0.5 * hard.ratio);
  CHECK(popOf(0.1).ratio < 0.75 * hard.ratio);
  CHECK(soft.longest < 1.03);
  CHECK(hard.longest < 1.0 + 1e-9);
}

TEST_CASE("A soft limb that is not moved stays, and goes on from there without a kink") {
  constexpr double near = 1e-6;
  for (const double softness : {0.05, 0.1, 0.2, 0.3}) {
    for (const double poseReach : {0.4, 0.72, 0.85, 0.97, 1.0}) {
      const auto reached = [&](double distance) { return softReach(1.0, poseReach, distance, softness); };
      CAPTURE(softness, poseReach);
      if (1.0 - poseReach < softness) {
        CHECK(reached(poseReach) == Approx(poseReach).margin(1e-12));
      }
      for (const double joint : {1.0 - softness, poseReach}) {
        const double before = (reached(joint) - reached(joint - near)) / near;
        const double after = (reached(joint + near) - reached(joint)) / near;
        CHECK(before == Approx(after).margin(1e-4));
      }
      for (double distance = 0.3; distance < 1.5; distance += 0.01) {
        CHECK(reached(distance) <= 1.0);
        CHECK(reached(distance + 0.01) >= reached(distance) - 1e-12);
      }
    }
  }
}

TEST_CASE("A limb that is bent against its usual side and bends no farther stays on that side") {
  TwoBoneProblem leg = hangingLeg(-0.01, 0.0);
  const Quat swing = axisAngle(Vec3(0.0, 0.0, 1.0), 0.3);
  leg.target = leg.base + swing * (leg.end - leg.base);
  const TwoBoneShape shape = solveTwoBone(leg);
  CHECK(glm::length(shape.joint - leg.base - swing * (leg.joint - leg.base)) < 1e-9);
}

// How much two hands work together, and where their middle can be.
#include "rig/retarget/joined_hands.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double degree = pi / 180.0;

/// Joints of both arms and the first ones of both legs, at the places of a body whose trunk stands upright.
struct TwoArms {
  Skeleton skeleton;
  std::vector<Vec3> places{{0.2, 1.4, 0.0},  {0.3, 1.2, 0.1},  {0.1, 1.2, 0.4}, {-0.2, 1.4, 0.0},
                           {-0.3, 1.2, 0.1}, {-0.1, 1.2, 0.4}, {0.1, 0.9, 0.0}, {-0.1, 0.9, 0.0}};

  TwoArms() {
    for (const std::size_t side : {leftSide, rightSide}) {
      SkeletonArm arm;
      arm.limb.joints = {NodeIndex(3 * side), NodeIndex(3 * side + 1)};
      arm.limb.endNode = NodeIndex(3 * side + 2);
      skeleton.arms[side] = arm;
      skeleton.legs[side].limb.joints = {NodeIndex(6 + side)};
    }
    skeleton.bind = worlds();
  }

  [[nodiscard]] std::vector<Mat4> worlds(const Transform& above = {}) const {
    std::vector<Mat4> all;
    for (const Vec3& place : places) {
      Transform at;
      at.translation = place;
      all.push_back(toMatrix(above) * toMatrix(at));
    }
    return all;
  }

  /// Wrists so far apart against the elbows, in this direction from the trunk's way down towards the front.
  void putWrists(double ratio, double angleDegrees) {
    const double angle = angleDegrees * degree;
    const Vec3 middle = Vec3(0.0, 1.4, 0.0) + 0.45 * Vec3(0.0, -std::cos(angle), std::sin(angle));
    places[2] = middle + Vec3(0.3 * ratio, 0.0, 0.0);
    places[5] = middle - Vec3(0.3 * ratio, 0.0, 0.0);
  }
};

double eased(double share) {
  const double u = std::clamp(share, 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

double distance(const Vec3& a, const Vec3& b) {
  return glm::length(a - b);
}

} // namespace

TEST_CASE("hands work together by how near the wrists are to each other and how far from hanging") {
  TwoArms body;
  for (const double ratio : {0.0, 0.5, 0.99, 1.0, 1.03, 1.075, 1.12, 1.149, 1.15, 1.2, 3.0}) {
    for (const double angle : {0.0, 19.0, 20.0, 22.0, 27.5, 33.0, 35.0, 36.0, 90.0, 179.0}) {
      CAPTURE(ratio, angle);
      body.putWrists(ratio, angle);
      const JoinedHands hands = joinedHands(body.skeleton, body.worlds(), 0.4);
      CHECK(hands.share ==
            Approx((1.0 - eased((ratio - 1.0) / 0.15)) * eased((angle - 20.0) / 15.0)).margin(1e-6));
      CHECK(distance(hands.leftToRight, Vec3(-1.5 * ratio, 0.0, 0.0)) < 1e-12);
    }
  }
}

TEST_CASE("hands work together alike wherever a body stands and however it is turned") {
  Row row(31);
  TwoArms body;
  for (int i = 0; i < 20; ++i) {
    body.putWrists(row.between(1.01, 1.14), row.between(21.0, 34.0));
    const JoinedHands upright = joinedHands(body.skeleton, body.worlds(), 0.4);
    Transform above;
    above.translation = row.vector(3.0);
    above.rotation = axisAngle(glm::normalize(row.vector(1.0) + Vec3(0.01)), row.around(3.0));
    const JoinedHands turned = joinedHands(body.skeleton, body.worlds(above), 0.4);
    CHECK(upright.share > 0.0);
    CHECK(turned.share == Approx(upright.share).epsilon(1e-6));
    CHECK(distance(turned.leftToRight, above.rotation * upright.leftToRight) < 1e-9);
  }
}

TEST_CASE("an arm of one bone and arms whose elbows meet do no work together") {
  TwoArms body;
  body.putWrists(0.5, 90.0);
  REQUIRE(joinedHands(body.skeleton, body.worlds(), 0.4).share == 1.0);
  for (const std::size_t side : {leftSide, rightSide}) {
    TwoArms shorter = body;
    shorter.skeleton.arms[side]->limb.joints.pop_back();
    CHECK(joinedHands(shorter.skeleton, shorter.worlds(), 0.4).share == 0.0);
  }
  body.places[1] = body.places[4];
  CHECK(joinedHands(body.skeleton, body.worlds(), 0.4).share == 0.0);
}

TEST_CASE("shoulders are as wide as the arms' first joints are apart in the bind pose") {
  const TwoArms body;
  REQUIRE(shoulderWidth(body.skeleton));
  CHECK(*shoulderWidth(body.skeleton) == Approx(0.4));
  for (const std::size_t side : {leftSide, rightSide}) {
    Skeleton oneArmed = body.skeleton;
    oneArmed.arms[side].reset();
    CHECK_FALSE(shoulderWidth(oneArmed));
  }
  Skeleton tall = body.skeleton;
  tall.height = 399.0;
  CHECK(shoulderWidth(tall));
  tall.height = 401.0;
  CHECK_FALSE(shoulderWidth(tall));
}

TEST_CASE("a place in both balls stays, and one outside is brought to the edge of the ball that it leaves") {
  const std::array<Ball, 2> balls{Ball{{0.0, 0.0, 0.0}, 1.0}, Ball{{0.5, 0.0, 0.0}, 4.0}};
  const std::array<Ball, 2> other{balls[1], balls[0]};
  const Vec3 inside(0.2, -0.3, 0.4);
  const Vec3 beside(0.0, 1.5, 2.0);
  for (const std::array<Ball, 2>& pair : {balls, other}) {
    CHECK(middleInReach(pair, inside) == inside);
    CHECK(distance(middleInReach(pair, beside), Vec3(0.0, 0.6, 0.8)) < 1e-12);
  }
}

TEST_CASE("hands of two reaches that meet are brought into both of them") {
  Row row(7);
  int moved = 0;
  for (int i = 0; i < 300; ++i) {
    const Ball first{row.vector(1.0), row.between(0.3, 1.0)};
    const Ball second{row.vector(1.0), row.between(0.3, 1.0)};
    if (distance(first.centre, second.centre) > 0.7 * (first.radius + second.radius)) {
      continue;
    }
    const Vec3 wanted = row.vector(2.0);
    const Vec3 place = middleInReach({first, second}, wanted);
    moved += place != wanted ? 1 : 0;
    CHECK(distance(place, first.centre) < 1.001 * first.radius);
    CHECK(distance(place, second.centre) < 1.001 * second.radius);
  }
  CHECK(moved > 30);
}

TEST_CASE("hands of two reaches that do not meet come between them") {
  const std::array<Ball, 2> balls{Ball{{0.0, 0.0, 0.0}, 1.0}, Ball{{4.0, 0.0, 0.0}, 1.5}};
  const Vec3 place = middleInReach(balls, Vec3(2.0, 1.0, -1.0));
  CHECK(distance(place, Vec3(2.5, 0.0, 0.0)) < 1e-3);
}

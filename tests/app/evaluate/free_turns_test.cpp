// Limbs that turn though their ends do not make it.
#include "app/evaluate/free_turns.h"

#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "core/math/types.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double degrees = pi / 180.0;
const Vec3 down(0.0, -1.0, 0.0);
const Vec3 side(1.0, 0.0, 0.0);
const Quat noTurn(1.0, 0.0, 0.0, 0.0);

/// A leg that hangs from the origin, its knee bent forwards by twice 40 degrees, turned as a whole.
TurnedLimb bentLeg(const Quat& turn, const Quat& carrier = noTurn) {
  const Vec3 thigh = axisAngle(side, -40.0 * degrees) * down;
  const Vec3 shin = axisAngle(side, 40.0 * degrees) * down;
  return {{Vec3(0.0), turn * thigh, turn * (thigh + shin)}, {turn, turn}, {carrier}};
}

Quat about(const Vec3& axis, double angleDegrees) {
  return axisAngle(axis, angleDegrees * degrees);
}

const TurnedLimb kept = bentLeg(noTurn);

} // namespace

TEST_CASE("A knee that goes round the line from hip to foot turns freely, by as much as it goes") {
  const TurnedLimb turned = bentLeg(about(down, 30.0));
  const FreeTurn found = freeTurn({kept, kept}, {kept, turned}, 5.0);
  CHECK(found.degrees == Approx(30.0));
  CHECK(found.sourceDegrees == Approx(0.0).margin(1e-6));
  CHECK(freeTurn({kept, kept}, {kept, turned}, 31.0).degrees == 0.0); // so much is allowed
}

TEST_CASE("A leg that swings because its foot does is not turned freely, nor one that bends") {
  for (const Vec3& axis : {side, Vec3(0.0, 0.0, 1.0)}) {
    CHECK(freeTurn({kept, kept}, {kept, bentLeg(about(axis, 30.0))}, 5.0).degrees == 0.0);
  }
  TurnedLimb bent = kept; // by 30 degrees more at hip and knee
  bent.points[1] = about(side, -30.0) * kept.points[1];
  bent.points[2] = bent.points[1] + about(side, 30.0) * (kept.points[2] - kept.points[1]);
  bent.joints = {about(side, -30.0), about(side, 30.0)};
  CHECK(freeTurn({kept, kept}, {kept, bent}, 5.0).degrees == 0.0);
}

TEST_CASE("A leg that turns in the clip may turn by twice that, and one whose hips are turned by that more") {
  const TurnedLimb slow = bentLeg(about(down, 13.0));
  const TurnedLimb fast = bentLeg(about(down, 30.0));
  CHECK(freeTurn({kept, slow}, {kept, fast}, 5.0).degrees == 0.0);
  const TurnedLimb carried = bentLeg(about(down, 30.0), about(down, 26.0));
  CHECK(freeTurn({kept, kept}, {kept, carried}, 5.0).degrees == 0.0);
  // The hips of the clip turn as far: nothing was asked of them.
  const TurnedLimb turning = bentLeg(noTurn, about(down, 26.0));
  CHECK(freeTurn({kept, turning}, {kept, carried}, 5.0).degrees == Approx(30.0));
}

TEST_CASE("A foot that stands as near to its hip as the leg allows tells no direction, and is left out") {
  const TurnedLimb folded{
      {Vec3(0.0), Vec3(0.0, 0.0, 1.0), Vec3(0.0, -0.05, 0.0)}, {noTurn, noTurn}, {noTurn}};
  TurnedLimb turned = folded;
  for (Vec3& point : turned.points) {
    point = about(down, 90.0) * point;
  }
  turned.joints = {about(down, 90.0), about(down, 90.0)};
  CHECK(freeTurn({folded, folded}, {folded, turned}, 5.0).degrees == 0.0);
  CHECK(freeTurn({folded, folded}, {turned, folded}, 5.0).degrees == 0.0);
}

TEST_CASE("A thigh that turns about itself does so freely, whatever its knee does") {
  TurnedLimb rolled = kept;
  rolled.joints[0] = about(glm::normalize(kept.points[1]), 20.0);
  CHECK(freeTurn({kept, kept}, {kept, rolled}, 5.0).degrees == Approx(20.0));
}

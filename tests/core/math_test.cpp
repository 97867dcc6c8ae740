#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/euler.h"
#include "core/math/median.h"
#include "core/math/monotone_curve.h"
#include "core/math/rotation.h"
#include "core/math/srgb.h"
#include "core/math/transform.h"
#include "tests/support/matrices.h"

using namespace stretch;
using stretch::test::largestDifference;

namespace {

void checkSame(const Vec3& is, const Vec3& wanted) {
  CAPTURE(is.x, is.y, is.z, wanted.x, wanted.y, wanted.z);
  CHECK(glm::length(is - wanted) < 1e-9);
}

} // namespace

TEST_CASE("The shortest arc turns one direction into the other, whatever their lengths") {
  const Vec3 from = GENERATE(Vec3(1, 0, 0), Vec3(0, 0.02, 0), Vec3(3, -4, 12));
  const Vec3 to = GENERATE(Vec3(0, 5, 0), Vec3(0, 0, -0.1), Vec3(-2, 1, 2));
  const Quat arc = shortestArc(from, to);
  CHECK(glm::length(arc) == Approx(1.0));
  checkSame(arc * glm::normalize(from), glm::normalize(to));
  const Vec3 axis(arc.x, arc.y, arc.z);
  CHECK(std::abs(glm::dot(axis, from)) < 1e-9 * glm::length(from)); // no twist about either
  CHECK(std::abs(glm::dot(axis, to)) < 1e-9 * glm::length(to));
}

TEST_CASE("Between directions that are the same, opposite or none the shortest arc is still a rotation") {
  for (const Vec3& direction : {Vec3(2, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 0.5), Vec3(1, 1, 1)}) {
    CAPTURE(direction.x, direction.y, direction.z);
    CHECK(shortestArc(direction, 4.0 * direction) == Quat(1.0, 0.0, 0.0, 0.0));
    const Quat half = shortestArc(direction, -2.0 * direction);
    CHECK(glm::length(half) == Approx(1.0));
    checkSame(half * direction, -direction);
    CHECK(shortestArc(direction, Vec3(0.0)) == Quat(1.0, 0.0, 0.0, 0.0));
    CHECK(shortestArc(Vec3(0.0), direction) == Quat(1.0, 0.0, 0.0, 0.0));
    CHECK(glm::length(anyPerpendicular(direction)) == Approx(1.0));
    CHECK(std::abs(glm::dot(anyPerpendicular(direction), direction)) < 1e-12);
  }
  CHECK(anyPerpendicular(Vec3(0.0)) == Vec3(1, 0, 0));
}

TEST_CASE("The angle between rotations is the smaller one, and a cosine that of directions of any length") {
  const Quat half(std::cos(0.2), 0.0, 0.0, std::sin(0.2)); // 0.4 radians about z
  CHECK(angleBetween(half, Quat(1.0, 0.0, 0.0, 0.0)) == Approx(0.4));
  CHECK(angleBetween(-half, Quat(1.0, 0.0, 0.0, 0.0)) == Approx(0.4));
  CHECK(angleBetween(half, half) == Approx(0.0).margin(1e-7));
  CHECK(angleBetween(Quat(0.0, 1.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0)) == Approx(pi));
  CHECK(cosineBetween(Vec3(2, 0, 0), Vec3(3, 3, 0)) == Approx(std::sqrt(0.5)));
  CHECK(cosineBetween(Vec3(0, 2, 0), Vec3(0, -0.1, 0)) == Approx(-1.0));
  CHECK(cosineBetween(Vec3(0.0), Vec3(0, 1, 0)) == 0.0);
  CHECK(isTurn(half));
  CHECK(isTurn(Quat(1.0, 1e-10, 0.0, 0.0)));
  CHECK_FALSE(isTurn(Quat(1.0, 1e-12, 0.0, 0.0)));
  CHECK_FALSE(isTurn(Quat(-1.0, 0.0, 0.0, 0.0)));
}

TEST_CASE("A rotation about an axis is right-handed, and an angle is told from 0 to a half turn") {
  checkSame(axisAngle(Vec3(0, 0, 1), 0.5 * pi) * Vec3(1, 0, 0), Vec3(0, 1, 0));
  checkSame(axisAngle(Vec3(0, 1, 0), 0.5 * pi) * Vec3(1, 0, 0), Vec3(0, 0, -1));
  checkSame(axisAngle(Vec3(1, 0, 0), pi / 3) * Vec3(0, 2, 0), Vec3(0, 1, std::sqrt(3.0)));
  CHECK(angleBetween(Vec3(2, 0, 0), Vec3(0, 0.1, 0)) == Approx(0.5 * pi));
  CHECK(angleBetween(Vec3(1, 0, 0), Vec3(-3, 0, 0)) == Approx(pi));
  CHECK(angleBetween(Vec3(1, 0, 0), Vec3(1, 1e-9, 0)) == Approx(1e-9));
  CHECK(angleBetween(Vec3(0.0), Vec3(1, 0, 0)) == 0.0);
}

TEST_CASE("A matrix with a single axis keeps its direction, however short it is, whichever it is") {
  const int axis = GENERATE(0, 1, 2);
  const double size = GENERATE(0.01, 1.0, 50.0);
  const Vec3 direction = glm::normalize(Vec3(0.3, -0.8, 0.5));
  Mat4 matrix(0.0);
  matrix[axis] = Vec4(size * direction, 0.0);
  matrix[3] = Vec4(1, 2, 3, 1);
  const Transform parts = toTransform(matrix);
  CHECK(glm::length(parts.rotation) == Approx(1.0));
  Vec3 unit(0.0);
  unit[axis] = 1.0;
  checkSame(parts.rotation * unit, direction);
  CHECK(largestDifference(toMatrix(parts), matrix) < 1e-10);
}

TEST_CASE(
    "A matrix whose axes stand aslant has the rotation of its first axis, and of the second beside it") {
  Mat4 matrix(1.0);
  matrix[0] = Vec4(0, 2, 0, 0);
  matrix[1] = Vec4(-3, 1, 0, 0); // leans towards the first
  matrix[2] = Vec4(0, 0, 4, 0);
  const Transform parts = toTransform(matrix);
  checkSame(parts.rotation * Vec3(1, 0, 0), Vec3(0, 1, 0));
  checkSame(parts.rotation * Vec3(0, 1, 0), Vec3(-1, 0, 0));
  checkSame(parts.scale, Vec3(2, std::sqrt(10.0), 4));
  matrix[2] = Vec4(0, 0, -4, 0);
  const Transform mirrored = toTransform(matrix);
  checkSame(mirrored.scale, Vec3(-2, std::sqrt(10.0), 4));
  checkSame(mirrored.rotation * Vec3(1, 0, 0), Vec3(0, -1, 0));
  checkSame(mirrored.rotation * Vec3(0, 0, 1), Vec3(0, 0, -1));
}

TEST_CASE("A monotone curve goes through its points, is held beside them and passes between as calculated") {
  const MonotoneCurve curve({{0.0, 1.0}, {2.0, 3.0}, {3.0, 9.0}, {5.0, 9.0}});
  CHECK(curve.at(-1.0) == 1.0);
  CHECK(curve.at(0.0) == 1.0);
  CHECK(curve.at(2.0) == Approx(3.0));
  CHECK(curve.at(3.0) == Approx(9.0));
  CHECK(curve.at(5.0) == 9.0);
  CHECK(curve.at(7.0) == 9.0);
  CHECK(curve.at(4.0) == Approx(9.0)); // flat at the extreme
  // Slope at 2: secants 1 and 6 over lengths 2 and 1: 3 * 3 / ((2 + 2) / 1 + (1 + 4) / 6).
  const double slope = 9.0 / (4.0 + 5.0 / 6.0);
  CHECK(monotoneSlope({0, 1}, {2, 3}, {3, 9}) == Approx(slope));
  CHECK(curve.at(1.0) == Approx(0.5 * (1.0 + 3.0) - 0.125 * 2.0 * slope));
  // At a quarter of the piece from 2 to 3.
  const double t = 0.25;
  CHECK(curve.at(2.25) == Approx((2 * t * t * t - 3 * t * t + 1) * 3.0 + (t * t * t - 2 * t * t + t) * slope +
                                 (3 * t * t - 2 * t * t * t) * 9.0));
  CHECK(monotoneSlope({0, 0}, {1, 2}, {2, 0}) == 0.0);
  CHECK(monotoneSlope({0, 0}, {1, 2}, {2, 2}) == 0.0);
  CHECK(monotoneSlope({0, 4}, {1, 2}, {2, 0}) == Approx(-2.0));
}

TEST_CASE("Three angles are those nearest to the ones before, and give their rotation back") {
  const Vec3 angles = GENERATE(Vec3(0.3, -0.4, 0.9), Vec3(3.5, 0.2, -4.0), Vec3(-0.1, 1.4, 7.0));
  const Quat rotation = rotationOf(angles);
  const Quat byHand = axisAngle(Vec3(0, 0, 1), angles.z) * axisAngle(Vec3(0, 1, 0), angles.y) *
                      axisAngle(Vec3(1, 0, 0), angles.x);
  CHECK(std::abs(glm::dot(rotation, byHand)) == Approx(1.0));
  checkSame(eulerNear(rotation, angles + Vec3(0.1, -0.1, 0.05)), angles);
  checkSame(eulerNear(rotation, angles + Vec3(2.0 * pi, 0.0, -4.0 * pi)),
            angles + Vec3(2.0 * pi, 0.0, -4.0 * pi));
}

TEST_CASE("What angles change by is what their rotation changes by, there and back") {
  const Vec3 angles(0.3, -0.4, 0.9);
  const Vec3 rates = GENERATE(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.5, -2.0, 1.5));
  const Quat rate = rotationRate(angles, rates);
  const double step = 1e-6;
  const Quat later = rotationOf(angles + step * rates);
  const Quat sooner = rotationOf(angles - step * rates);
  const Quat measured = (later + sooner * -1.0) / (2.0 * step);
  CHECK(glm::length(rate + measured * -1.0) < 1e-7);
  CHECK(glm::length(eulerRate(rotationOf(angles), rate, angles) - rates) < 1e-6);
  CHECK(glm::length(eulerRate(rotationOf(angles) * 3.0, rate * 3.0, angles) - rates) < 1e-6);
  CHECK(eulerRate(rotationOf(angles), Quat(0, 0, 0, 0), angles) == Vec3(0.0));
}

TEST_CASE("The median is the middle one, the upper of two") {
  CHECK(medianOf({}, 7.0) == 7.0);
  CHECK(medianOf({3.0}, 7.0) == 3.0);
  CHECK(medianOf({5.0, 1.0}, 7.0) == 5.0);
  CHECK(medianOf({9.0, 1.0, 4.0}, 7.0) == 4.0);
  CHECK(medianOf({9.0, 1.0, 4.0, 6.0}, 7.0) == 6.0);
}

TEST_CASE("A box is empty until a point is in it, and as long as its longest side") {
  Bounds box;
  CHECK(box.empty());
  CHECK(box.largestExtent() == 0.0);
  box.add(Vec3(1, 2, 3));
  CHECK_FALSE(box.empty());
  CHECK(box.largestExtent() == 0.0);
  box.add(Vec3(-1, 2.5, 8));
  CHECK(box.low == Vec3(-1, 2, 3));
  CHECK(box.high == Vec3(1, 2.5, 8));
  CHECK(box.largestExtent() == 5.0);
}

TEST_CASE("A colour goes to linear light as the standard's table has it, and back") {
  for (const auto& [encoded, linear] : {std::pair(0.0, 0.0),
                                        {0.04, 0.04 / 12.92},
                                        {0.06, 0.004896310},
                                        {0.5, 0.214041140},
                                        {0.8, 0.603827339},
                                        {1.0, 1.0}}) {
    CHECK(linearFromSrgb(encoded) == Approx(linear).margin(1e-8));
    CHECK(srgbFromLinear(linear) == Approx(encoded).margin(1e-7));
  }
}

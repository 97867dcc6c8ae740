#include <catch2/catch.hpp>

#include "core/math/transform.h"
#include "tests/support/matrices.h"

using namespace stretch;
using stretch::test::largestDifference;

TEST_CASE("A transform scales first, then turns, then moves") {
  const Transform transform{Vec3(1, 2, 3), glm::angleAxis(pi / 2, Vec3(0, 0, 1)), Vec3(2, 5, 7)};
  const Vec3 point(toMatrix(transform) * Vec4(1, 0, 0, 1));
  CHECK(glm::length(point - Vec3(1, 4, 3)) < 1e-12);
}

TEST_CASE("Translation, rotation and scale come back from their matrix, mirrors included") {
  const Vec3 scale =
      GENERATE(Vec3(1, 1, 1), Vec3(0.01, 200, 3), Vec3(-1, 2, 3), Vec3(1, -2, 3), Vec3(-1, -2, -3));
  const Quat rotation = glm::normalize(Quat(0.3, -0.5, 0.7, 0.2));
  const Mat4 matrix = toMatrix({Vec3(4, 5, 6), rotation, scale});
  const Transform parts = toTransform(matrix);
  CHECK(largestDifference(toMatrix(parts), matrix) < 1e-10);
  CHECK(glm::length(parts.rotation) == Approx(1.0));
}

TEST_CASE("A flat matrix still has a rotation") {
  const Vec3 scale =
      GENERATE(Vec3(2, 0, 3), Vec3(0, 2, 3), Vec3(2, 3, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 2));
  const Mat4 flat = toMatrix({Vec3(0.0), glm::normalize(Quat(0.3, -0.5, 0.7, 0.2)), scale});
  const Transform parts = toTransform(flat);
  CHECK(glm::length(parts.rotation) == Approx(1.0));
  CHECK(largestDifference(toMatrix(parts), flat) < 1e-10);
}

TEST_CASE("A point has a rotation and no size") {
  const Transform parts = toTransform(Mat4(0.0));
  CHECK(parts.scale == Vec3(0.0));
  CHECK(glm::length(parts.rotation) == Approx(1.0));
}

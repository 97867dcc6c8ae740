#include "skinning/elastic/bone_strains.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "tests/support/matrices.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

LimbStretch loaded(double flattening, double along, const Vec3& axis, const Vec3& load) {
  return {combine(flattening, along), axis, load};
}

} // namespace

TEST_CASE("a load that keeps its side of the bone flattens by all of what the model says") {
  const Vec3 axis = glm::normalize(Vec3(0.2, 1.0, -0.4));
  const Vec3 load = glm::normalize(glm::cross(axis, Vec3(0.3, 0.1, 0.9)));
  const Mat3 toJoint = glm::mat3_cast(axisAngle(glm::normalize(Vec3(1.0, 2.0, 3.0)), 0.7));
  std::vector<std::vector<LimbStretch>> stretches;
  std::vector<std::vector<Mat3>> spaces;
  for (const double q : {0.05, 0.1, 0.2}) {
    stretches.push_back({loaded(q, 1.0 + q, axis, load)});
    spaces.push_back({toJoint});
  }
  const std::vector<std::vector<Mat3>> strains = boneStrains(stretches, spaces);
  for (std::size_t k = 0; k < strains.size(); ++k) {
    const Mat3 stretch = glm::transpose(toJoint) * (Mat3(1.0) + strains[k][0]) * toJoint;
    const StretchFactors& factors = stretches[k][0].factors;
    CHECK(glm::length(stretch * axis - factors.along * axis) < 1e-12);
    CHECK(glm::length(stretch * load - factors.withLoad * load) < 1e-12);
    CHECK(glm::determinant(stretch) == Approx(1.0));
  }
}

TEST_CASE("a load that circles the bone keeps the volume, and the axes stay where they are") {
  const Vec3 axis(0.0, 1.0, 0.0);
  std::vector<std::vector<LimbStretch>> stretches;
  for (int k = 0; k < 24; ++k) {
    const double angle = 0.25 * k;
    const double q = k < 8 ? 0.2 : 0.1;
    stretches.push_back({loaded(q, 0.9, axis, Vec3(std::cos(angle), 0.0, std::sin(angle)))});
  }
  const std::vector<std::vector<Mat3>> spaces(24, {Mat3(1.0)});
  const std::vector<std::vector<Mat3>> strains = boneStrains(stretches, spaces);
  for (const std::vector<Mat3>& sample : strains) {
    CHECK(glm::determinant(Mat3(1.0) + sample[0]) == Approx(1.0));
    // Stretches with common axes commute.
    CHECK(test::largestDifference(sample[0] * strains[0][0], strains[0][0] * sample[0]) < 1e-12);
  }
}

TEST_CASE("where nothing gives way the strain is exactly zero") {
  const std::vector<std::vector<Mat3>> strains =
      boneStrains({{loaded(0.0, 1.0, Vec3(0.6, 0.8, 0.0), Vec3(0.0, 0.0, 1.0))}}, {{Mat3(1.0)}});
  CHECK(strains[0][0] == Mat3(0.0));
}

TEST_CASE("of loads from two sides a bone gives way to the stronger one, and to none of the other") {
  const Vec3 axis = glm::normalize(Vec3(0.2, 1.0, -0.4));
  const Vec3 strong = glm::normalize(glm::cross(axis, Vec3(0.3, 0.1, 0.9)));
  // Half of a right angle aside it changes nothing along the axes of the stronger one.
  const Vec3 weak = glm::normalize(strong + glm::cross(axis, strong));
  const std::vector<std::vector<Mat3>> strains = boneStrains(
      {{loaded(0.2, 1.0, axis, strong)}, {loaded(0.05, 1.0, axis, weak)}}, {{Mat3(1.0)}, {Mat3(1.0)}});
  CHECK(glm::length(strains[0][0] * strong + 0.2 * strong) < 1e-12);
  CHECK(test::largestDifference(strains[1][0], Mat3(0.0)) < 1e-12);
}

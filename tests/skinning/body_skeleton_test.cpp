#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "skinning/body/body_skeleton.h"
#include "skinning/geometry/shape_diameter.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A tube with few vertices around it, and its centre line of 30 segments, which is shorter than two rings.
struct CoarseTube {
  CoarseTube() : shape(test::tube(10.0, 0.5, 60, 10)) {
    const auto diameters = shapeDiameters(shape.positions.data(), shape.positions.size(), shape.triangles);
    REQUIRE(diameters);
    const auto made = skeletonOfBody(shape.positions.data(), shape.positions.size(), shape.triangles,
                                     diameters->vertices, 30);
    REQUIRE(made);
    skeleton = *made;
  }
  test::Shape shape;
  BodySkeleton skeleton;
};

} // namespace

TEST_CASE("joints begin on the centre line, however few vertices lie around them") {
  const CoarseTube tube;
  const JointTracker tracker(tube.skeleton, tube.shape.positions.data());
  const std::vector<Vec3> joints = tracker.joints(tube.shape.positions.data());
  REQUIRE(joints.size() == tube.skeleton.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    CHECK(glm::distance(joints[j], tube.skeleton.joints[j]) < 1e-5);
  }
}

TEST_CASE("joints follow a body that is turned, moved and stretched as its vertices do") {
  const CoarseTube tube;
  const JointTracker tracker(tube.skeleton, tube.shape.positions.data());
  const Mat3 linear(Vec3(0.0, 1.2, 0.1), Vec3(-0.7, 0.0, 0.0), Vec3(0.0, 0.0, 1.4));
  const Vec3 shift(3.0, -2.0, 5.0);
  std::vector<glm::vec3> moved;
  for (const glm::vec3& p : tube.shape.positions) {
    moved.emplace_back(linear * Vec3(p) + shift);
  }
  const std::vector<Vec3> joints = tracker.joints(moved.data());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    CHECK(glm::distance(joints[j], linear * tube.skeleton.joints[j] + shift) < 1e-4);
  }
}

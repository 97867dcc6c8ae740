// What shells that hold no bone follow: the bones that are nearest to each part of them in space.
#include <cstddef>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/bind/bind_weights.h"
#include "tests/support/refusal.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/skinning/weight_of.h"

using namespace stretch;
using skinning::BindJoint;
using skinning::BoundBody;

namespace {

constexpr double length = 10.0;

/// A tube with two bones in it, and beside it so far a thinner one that holds none, as long.
test::Shape tubeBesideTube(double apart) {
  test::Shape shape = test::tube(length, 1.0, 40, 12);
  const test::Shape beside = test::tube(length, 0.5, 40, 8);
  const auto first = static_cast<std::uint32_t>(shape.positions.size());
  for (const glm::vec3& place : beside.positions) {
    shape.positions.push_back(place + glm::vec3(0.0F, static_cast<float>(apart), 0.0F));
  }
  for (const Triangle& t : beside.triangles) {
    shape.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return shape;
}

const std::vector<BindJoint> bonesOfTube{{Vec3(0, 0, 0), -1}, {Vec3(5, 0, 0), 0}, {Vec3(9.5, 0, 0), 1}};

} // namespace

TEST_CASE("A long shell beside a body follows each bone along its part of it", "[shells-apart]") {
  const double apart = GENERATE(-2.5, 2.0, 4.0);
  const test::Shape shape = tubeBesideTube(apart);
  const Result<BoundBody> bound = skinning::bindWeights(shape.positions, shape.triangles, bonesOfTube);
  REQUIRE(test::refusal(bound) == "accepted");
  const std::size_t first = test::tube(length, 1.0, 40, 12).positions.size();
  for (std::size_t v = first; v < shape.positions.size(); ++v) {
    const auto x = static_cast<double>(shape.positions[v].x);
    CAPTURE(x, shape.positions[v].y);
    const double ofFirst = test::weightOf(bound->influences[v], 0);
    const double ofSecond = test::weightOf(bound->influences[v], 1);
    CHECK(ofFirst + ofSecond + test::weightOf(bound->influences[v], 2) == Approx(1.0).margin(1e-6));
    if (x < 3.0) {
      CHECK(ofFirst > 0.99);
    } else if (x > 7.0) {
      CHECK(ofFirst < 0.01);
    }
  }
}

// The same place of bodies of other widths, and what of a body is looked at.
#include "app/retarget/body_chart.h"

#include <numeric>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/retarget/touch_body.h"
#include "tests/support/rig/boxed_biped.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// A biped of boxes in its bind pose, with the places of its trunk and head.
struct ChartedBody {
  test::MovingBiped moving;
  rig::Skeleton skeleton;
  TouchBody touch;
  std::vector<Vec3> places;

  explicit ChartedBody(const test::BoxedBody& sizes)
      : moving(test::boxedBiped(sizes)), skeleton(test::skeletonOf(moving)), touch(skeleton),
        places(touch.placesOf(skeleton.bind)) {}

  [[nodiscard]] ChartPlace nearestTo(const Vec3& place) const {
    const auto point = skinning::nearestOn({places, touch.parts.trunk}, place);
    REQUIRE(point);
    return touch.chart.placeOf(*point);
  }
  [[nodiscard]] Vec3 placeOf(const ChartPlace& place) const {
    const auto point = touch.chart.pointAt(place);
    REQUIRE(point);
    return skinning::placeOf({places, touch.parts.trunk}, *point);
  }
};

} // namespace

TEST_CASE("A place on the trunk is as far to the side and to the front of a wider one, at the same height") {
  const ChartedBody narrow{test::BoxedBody{}};
  const ChartedBody wide{test::BoxedBody{.trunk = Vec3(0.3, 0.3, 0.24)}};
  const auto onWide = [&](const Vec3& place) { return wide.placeOf(narrow.nearestTo(place)); };
  const ChartPlace chest = narrow.nearestTo({0.1, 1.1, 0.5});
  CHECK_FALSE(chest.isOfHead);
  CHECK(chest.place.x == Approx(0.1 / 0.15).epsilon(1e-5));
  CHECK(chest.place.z == Approx(1.0).epsilon(1e-5));
  CHECK(glm::distance(onWide({0.1, 1.1, 0.5}), Vec3(0.2, 1.1, 0.24)) < 1e-5);
  CHECK(glm::distance(onWide({-0.05, 1.3, -0.5}), Vec3(-0.1, 1.3, -0.24)) < 1e-5);
  CHECK(glm::distance(onWide({0.5, 1.0, 0.03}), Vec3(0.3, 1.0, 0.06)) < 1e-5);
  CHECK(glm::distance(narrow.placeOf(chest), Vec3(0.1, 1.1, 0.12)) < 1e-5);
}

TEST_CASE("A place on the head is that of a larger head, in shares of it") {
  const ChartedBody small{test::BoxedBody{}};
  const ChartedBody large{test::BoxedBody{.head = Vec3(0.2)}};
  const ChartPlace face = small.nearestTo({0.05, 1.72, 0.5});
  CHECK(face.isOfHead);
  CHECK(glm::distance(face.place, Vec3(0.5, 0.4, 1.0)) < 1e-5);
  CHECK(glm::distance(large.placeOf(face), Vec3(0.1, 1.76, 0.2)) < 1e-5);
  const ChartedBody high{test::BoxedBody{.head = Vec3(0.2, 0.3, 0.15)}};
  CHECK(glm::distance(high.placeOf(face), Vec3(0.1, 1.8, 0.15)) < 1e-5);
}

TEST_CASE("A hand is as large as it reaches from the wrist, and an arm is a hand and a forearm") {
  const ChartedBody body{test::BoxedBody{}};
  CHECK(body.touch.hasSurface());
  for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
    CHECK(body.touch.hands[side].size() == 8);
    CHECK(body.touch.arms[side].size() == 16);
    CHECK(body.touch.handSizes[side] == Approx(0.13).epsilon(1e-5)); // 0.12 out, 0.04 and 0.03 aside
    CHECK(body.touch.depthOf(body.places, side) == 0.0);
  }
}

TEST_CASE("Of many vertices as many as are wanted are looked at, in even steps from the first") {
  std::vector<std::size_t> vertices(10);
  std::iota(vertices.begin(), vertices.end(), 0);
  CHECK(thinned(vertices, 10) == vertices);
  CHECK(thinned(vertices, 11) == vertices);
  CHECK(thinned(vertices, 9) == std::vector<std::size_t>{0, 2, 4, 6, 8});
  CHECK(thinned(vertices, 5) == std::vector<std::size_t>{0, 2, 4, 6, 8});
  CHECK(thinned(vertices, 3) == std::vector<std::size_t>{0, 4, 8});
  CHECK(thinned({}, 3).empty());
}

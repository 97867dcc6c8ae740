#include <cmath>
#include <optional>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/geometry/inside.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

// The corners of a cube from -1 to 1, its sides wound outwards; the last two triangles are its top.
struct Cube {
  std::vector<Vec3> places;
  std::vector<Triangle> triangles;

  Cube() {
    for (int i = 0; i < 8; ++i) {
      places.emplace_back((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    }
    triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 4, 6}, {0, 6, 2},
                 {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}};
  }
};

} // namespace

TEST_CASE("A closed surface winds once around what is inside it, and not around what is outside") {
  const Cube cube;
  CHECK(windingNumber({cube.places, cube.triangles}, Vec3(0.3, -0.2, 0.9)) == Approx(1.0));
  CHECK(windingNumber({cube.places, cube.triangles}, Vec3(0.3, -0.2, 1.1)) == Approx(0.0).margin(1e-9));
  CHECK(windingNumber({cube.places, {}}, Vec3(0.0)) == 0.0);
}

TEST_CASE("What is inside a surface with a hole is told from what is outside it") {
  Cube cube;
  cube.triangles.resize(10);
  CHECK(windingNumber({cube.places, cube.triangles}, Vec3(0.0)) == Approx(5.0 / 6.0));
  CHECK(windingNumber({cube.places, cube.triangles}, Vec3(0.0, -0.8, 0.0)) > 0.9);
  CHECK(windingNumber({cube.places, cube.triangles}, Vec3(0.0, 3.0, 0.0)) < 0.1);
}

TEST_CASE("The distance from a surface is that of its sides, its edges and its corners, as far as is asked") {
  const Cube cube;
  const PlacedSurface surface{cube.places, cube.triangles};
  CHECK(distanceFrom(surface, Vec3(0.2, 0.1, 1.5)) == Approx(0.5));
  CHECK(distanceFrom(surface, Vec3(0.2, 0.1, 0.9)) == Approx(0.1));
  CHECK(distanceFrom(surface, Vec3(1.3, 0.1, 1.4)) == Approx(0.5));
  CHECK(distanceFrom(surface, Vec3(2.0, 2.0, 2.0)) == Approx(std::sqrt(3.0)));
  CHECK(distanceFrom(surface, Vec3(0.2, 0.1, 4.0), 0.7) == 0.7);
}

TEST_CASE("The nearest point of a surface is told by its triangle and its shares of the corners") {
  const Cube cube;
  const PlacedSurface surface{cube.places, cube.triangles};
  for (const Vec3& place :
       {Vec3(0.2, 0.1, 1.5), Vec3(1.3, 0.1, 1.4), Vec3(2.0, 2.0, 2.0), Vec3(0.9, 0.2, 0.1)}) {
    const std::optional<SurfacePoint> nearest = nearestOn(surface, place);
    REQUIRE(nearest);
    CHECK(glm::length(placeOf(surface, *nearest) - place) == Approx(distanceFrom(surface, place)));
    CHECK(nearest->shares.x + nearest->shares.y + nearest->shares.z == Approx(1.0));
  }
  CHECK(placeOf(surface, *nearestOn(surface, Vec3(0.2, 0.1, 1.5))).z == Approx(1.0));
  CHECK_FALSE(nearestOn(surface, Vec3(0.2, 0.1, 4.0), 0.7));
}

TEST_CASE("A ray goes through a surface where it leaves it, and not behind its start") {
  const Cube cube;
  const PlacedSurface surface{cube.places, cube.triangles};
  const std::vector<SurfacePoint> from = crossedBy(surface, Vec3(0.2, 0.1, 0.3), Vec3(0.0, 0.0, 5.0));
  REQUIRE(from.size() == 1);
  CHECK(glm::length(placeOf(surface, from.front()) - Vec3(0.2, 0.1, 1.0)) < 1e-12);
  CHECK(crossedBy(surface, Vec3(0.2, 0.1, -3.0), Vec3(0.0, 0.0, 1.0)).size() == 2);
  CHECK(crossedBy(surface, Vec3(0.2, 0.1, 3.0), Vec3(0.0, 0.0, 1.0)).empty());
}

// A body as cubes: its layers, what joins its pieces, ways in it and where it ends, each against what is
// counted by hand or found in a slower way.
#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/bind/voxel_ways.h"
#include "skinning/locate/body_ends.h"
#include "skinning/locate/standing_body.h"
#include "tests/support/skinning/cube_bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/skinning/tube_person.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

std::vector<Vec3> placesOf(const test::Shape& shape, const Vec3& shift = Vec3(0.0)) {
  std::vector<Vec3> places;
  for (const glm::vec3& position : shape.positions) {
    places.push_back(Vec3(position) + shift);
  }
  return places;
}

/// Two shapes as one mesh, the second moved.
StandingBody standingPair(const test::Shape& one, const test::Shape& other, const Vec3& shift) {
  std::vector<Vec3> places = placesOf(one);
  std::vector<Triangle> triangles = one.triangles;
  const auto first = static_cast<std::uint32_t>(places.size());
  for (const Vec3& place : placesOf(other, shift)) {
    places.push_back(place);
  }
  for (const Triangle& triangle : other.triangles) {
    triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  }
  Result<StandingBody> body = standingBody(places, triangles, Upright{});
  REQUIRE(body);
  return std::move(body).value();
}

bool isSame(const SliceRegion& a, const SliceRegion& b) {
  return std::set(a.cells.begin(), a.cells.end()) == std::set(b.cells.begin(), b.cells.end()) &&
         glm::distance(a.middle, b.middle) < 1e-9 && a.low == b.low && a.high == b.high;
}

void checkLayers(const StandingBody& body) {
  const auto expected = test::layersByPairs(body.cubes);
  REQUIRE(body.layers.size() == expected.size());
  bool areSame = true;
  for (std::size_t layer = 0; layer < expected.size(); ++layer) {
    areSame = areSame && std::ranges::equal(body.layers[layer], expected[layer], isSame);
  }
  CHECK(areSame);
}

bool isOnePiece(const StandingBody& body) {
  std::vector<bool> isReached(body.cubes.cellCount(), false);
  std::vector<std::size_t> open{0};
  isReached[0] = true;
  std::size_t count = 0;
  for (; count < open.size(); ++count) {
    eachNeighbour(body.cubes, open[count], [&](std::size_t next, std::size_t) {
      if (!isReached[next]) {
        isReached[next] = true;
        open.push_back(next);
      }
    });
  }
  return count == body.cubes.cellCount();
}

/// Distance of two boxes of cells, in steps over faces of cubes.
int stepsBetween(const StandingBody& body, const std::function<bool(const Vec3&)>& isFirst) {
  glm::ivec3 from(0);
  glm::ivec3 to(1000);
  for (std::size_t cell = 0; cell < body.ownCells; ++cell) {
    const auto [x, y, z] = body.cubes.grid.placeOfIndex(body.cubes.cubeOf[cell]);
    (isFirst(body.middleOf(cell)) ? from : to) = isFirst(body.middleOf(cell))
                                                     ? glm::max(from, glm::ivec3(x, y, z))
                                                     : glm::min(to, glm::ivec3(x, y, z));
  }
  const glm::ivec3 gap = glm::max(to - from, glm::ivec3(0));
  return gap.x + gap.y + gap.z;
}

/// A star of rows of cubes around one in the middle, each so many long: +x, -x, +y, -y, +z, -z.
StandingBody star(const std::array<int, 6>& rows) {
  const glm::ivec3 middle(rows[1], rows[3], rows[5]);
  const glm::ivec3 counts(rows[0] + rows[1] + 1, rows[2] + rows[3] + 1, rows[4] + rows[5] + 1);
  return test::bodyOfCubes(counts, 1.0, Vec3(-0.5) - Vec3(middle), [=](int x, int y, int z) {
    return (x == middle.x) + (y == middle.y) + (z == middle.z) >= 2;
  });
}

std::uint32_t cellAt(const StandingBody& body, const Vec3& place) {
  return static_cast<std::uint32_t>(body.cubes.cellNear(place, 0));
}

} // namespace

TEST_CASE("The layers of a body are the heaps of cells that touch in them, over edges too", "[locators]") {
  const test::TubePerson person = test::tubePerson({.armsDown = 0.6, .everyNthHole = 11});
  Upright upright;
  upright.height = 1.8;
  const Result<StandingBody> standing = standingBody(person.positions, person.triangles, upright);
  REQUIRE(standing);
  checkLayers(*standing);
  CHECK(isOnePiece(*standing));
  CHECK(standing->ownCells <= standing->cubes.cellCount());
  const test::Shape steps =
      test::cubes({0, 0, 0}, {5, 5, 5}, 0.2, [](int x, int y, int z) { return (x + y + z) % 3 != 0; });
  const Result<StandingBody> uneven = standingBody(placesOf(steps), steps.triangles, Upright{});
  REQUIRE(uneven);
  checkLayers(*uneven);
}

TEST_CASE("A body is filled in its own space: turned, on its ground, one unit high", "[locators]") {
  const test::Shape box = test::box({2, 6, 3}, 1.0);
  Upright upright;
  upright.axes = Mat3(Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0));
  upright.origin = Vec3(0.0, 3.0, 1.5);
  upright.height = 2.0;
  const Result<StandingBody> body = standingBody(placesOf(box), box.triangles, upright);
  REQUIRE(body);
  Vec3 low(1e9);
  Vec3 high(-1e9);
  for (std::size_t cell = 0; cell < body->cubes.cellCount(); ++cell) {
    low = glm::min(low, body->middleOf(cell));
    high = glm::max(high, body->middleOf(cell));
  }
  const double cube = body->cubes.grid.size;
  CHECK(glm::distance(low, Vec3(-0.75, 0.0, -1.5)) < 2.0 * cube);
  CHECK(glm::distance(high, Vec3(0.75, 1.0, 1.5)) < 2.0 * cube);
  CHECK(body->upright.height == 2.0);
  CHECK(body->ownCells == body->cubes.cellCount());
}

TEST_CASE("Two pieces are joined by one row of cubes as long as the gap, as high up as may be",
          "[locators]") {
  const test::Shape box = test::box({2, 4, 2}, 0.1);
  for (const double gap : {0.06, 0.1, 0.17}) {
    const StandingBody body = standingPair(box, box, Vec3(0.2 + gap, 0.0, 0.0));
    INFO("a gap of " << gap);
    REQUIRE(body.cubes.cellCount() > body.ownCells);
    const double between = 0.2 + 0.5 * gap;
    const int steps = stepsBetween(body, [&](const Vec3& place) { return place.x < between; });
    CHECK(body.cubes.cellCount() - body.ownCells == static_cast<std::size_t>(steps - 1));
    CHECK(isOnePiece(body));
    checkLayers(body);
    double highest = 0.0;
    for (std::size_t cell = 0; cell < body.ownCells; ++cell) {
      highest = std::max(highest, body.middleOf(cell).y);
    }
    for (std::size_t cell = body.ownCells; cell < body.cubes.cellCount(); ++cell) {
      CHECK(body.isBridge(cell));
      CHECK(body.middleOf(cell).y == Approx(highest));
      CHECK(body.cubes.depths[cell] == Approx(0.5 * body.cubes.grid.size));
      CHECK(body.cubes.cellAt[body.cubes.cubeOf[cell]] == static_cast<std::int32_t>(cell));
    }
    CHECK_FALSE(body.isBridge(body.ownCells - 1));
  }
}

TEST_CASE("Pieces that are over corners of each other are joined along all three axes", "[locators]") {
  const test::Shape box = test::box({2, 2, 2}, 0.1);
  const StandingBody body = standingPair(box, box, Vec3(0.25, 0.28, 0.31));
  const int steps = stepsBetween(body, [](const Vec3& place) { return place.x < 0.225 && place.y < 0.24; });
  const auto joining = static_cast<int>(body.cubes.cellCount() - body.ownCells);
  CHECK(joining >= steps - 1);
  CHECK(joining <= steps); // ways that are about as long are as good
  CHECK(isOnePiece(body));
}

TEST_CASE("Each height lies in the layer of its own, those beyond the body in the first and last",
          "[locators]") {
  const StandingBody body = test::bodyOfCubes({2, 9, 2}, 0.1, Vec3(0.0), [](int, int, int) { return true; });
  REQUIRE(body.layers.size() == 11);
  for (std::size_t layer = 0; layer < body.layers.size(); ++layer) {
    CHECK(body.layerHeight(layer) == Approx(0.1 * static_cast<double>(layer) - 0.05));
    for (const double part : {-0.04, 0.0, 0.04}) {
      CHECK(body.layerAt(body.layerHeight(layer) + part) == layer);
    }
  }
  CHECK(body.layerAt(-7.0) == 0);
  CHECK(body.layerAt(7.0) == 10);
}

TEST_CASE("Ways from the centre begin at the cell nearest to the centroid and are the shortest",
          "[locators]") {
  std::mt19937 chance(3);
  for (int body = 0; body < 6; ++body) {
    const StandingBody standing = test::bodyOfCubes(
        {7, 8, 5}, 0.3, Vec3(-1.0, 0.0, 2.0), [&](int x, int, int) { return chance() % 10 < 4U + x / 2; });
    Vec3 centroid(0.0);
    for (std::size_t cell = 0; cell < standing.cubes.cellCount(); ++cell) {
      centroid += standing.middleOf(cell);
    }
    centroid /= static_cast<double>(standing.cubes.cellCount());
    std::uint32_t centre = 0;
    for (std::uint32_t cell = 0; cell < standing.cubes.cellCount(); ++cell) {
      if (glm::distance(standing.middleOf(cell), centroid) + 1e-9 <
          glm::distance(standing.middleOf(centre), centroid)) {
        centre = cell;
      }
    }
    const std::vector<double> ways = waysFromCentre(standing);
    const std::vector<double> expected = test::waysByRounds(standing.cubes, {centre});
    REQUIRE(ways.size() == expected.size());
    CHECK(ways[centre] == 0.0);
    for (std::size_t cell = 0; cell < ways.size(); ++cell) {
      CHECK((ways[cell] > 1e300 ? -1.0 : ways[cell]) ==
            Approx(expected[cell] > 1e300 ? -1.0 : expected[cell]));
    }
  }
}

TEST_CASE("Cells inwards are those farther out first, equal ones as they are numbered", "[locators]") {
  const std::vector<double> ways{2.0, 5.0, 0.0, 5.0, 3.0, 2.0, 5.0};
  const InwardOrder order = inwardOrder(ways);
  CHECK(order.cells == std::vector<std::size_t>{1, 3, 6, 4, 0, 5, 2});
  for (std::size_t cell = 0; cell < ways.size(); ++cell) {
    CHECK(order.cells[order.places[cell]] == cell);
  }
  CHECK(inwardOrder({}).cells.empty());
}

TEST_CASE("A star ends at the tip of each row, the longest first, as long as to where rows meet",
          "[locators]") {
  const StandingBody body = star({9, 6, 4, 2, 7, 3});
  const std::vector<double> ways = test::waysByRounds(body.cubes, {cellAt(body, Vec3(0.0))});
  const std::vector<std::pair<Vec3, double>> expected{{{9, 0, 0}, 9.0}, {{0, 0, 7}, 6.0},  {{-6, 0, 0}, 5.0},
                                                      {{0, 4, 0}, 3.0}, {{0, 0, -3}, 2.0}, {{0, -2, 0}, 1.0}};
  const std::vector<BodyEnd> ends = bodyEnds(body, ways, 0.0);
  REQUIRE(ends.size() >= expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(glm::distance(body.middleOf(ends[i].cell), expected[i].first) < 1e-9);
    CHECK(ends[i].length == Approx(expected[i].second));
    CHECK(glm::length(ends[i].root) <= (i == 0 ? 1e-9 : 1.0 + 1e-9));
  }
  CHECK(std::ranges::is_sorted(ends, std::greater<>{}, &BodyEnd::length));
}

TEST_CASE("Ends shorter than a share of the farthest way are none, as long ones are", "[locators]") {
  const StandingBody body = star({8, 6, 5, 3, 0, 0}); // 8, then 5, 4 and 2 up to where they meet
  const std::vector<double> ways = test::waysByRounds(body.cubes, {cellAt(body, Vec3(0.0))});
  CHECK(bodyEnds(body, ways, 0.25).size() == 4);
  CHECK(bodyEnds(body, ways, 0.251).size() == 3);
  CHECK(bodyEnds(body, ways, 0.5).size() == 3);
  CHECK(bodyEnds(body, ways, 0.51).size() == 2);
  CHECK(bodyEnds(body, ways, 0.626).size() == 1);
  CHECK(bodyEnds(body, ways, 2.0).size() == 1); // the farthest of all is an end however short
  CHECK(bodyEnds(test::bodyOfCubes({1, 1, 1}, 1.0, Vec3(0.0), [](int, int, int) { return false; }), {}, 0.1)
            .empty());
}

TEST_CASE("A body has as many ends as rows that are a fifth of the farthest way long", "[locators]") {
  CHECK(endsOf(star({10, 10, 6, 6, 3, 3})) == 6);
  CHECK(endsOf(star({10, 10, 6, 6, 2, 2})) == 4);
  CHECK(endsOf(star({10, 10, 2, 2, 2, 2})) == 2);
}

TEST_CASE("What is no body to fit joints to is told, each by its reason", "[locators]") {
  const auto told = [](std::span<const Vec3> places, const std::vector<Triangle>& triangles) {
    const Result<StandingBody> body = standingIn(places, triangles, UpAxis::ofScene, {});
    REQUIRE_FALSE(body);
    CHECK(body.error().remedy == std::string(byHand));
    return body.error().what;
  };
  const test::Shape box = test::box({2, 6, 2}, 1.0);
  CHECK(told(placesOf(box), {}) == "no mesh with triangles is there to fit locators to");
  const test::Shape sheet = test::plane(4, 0.0);
  CHECK(told(placesOf(sheet), sheet.triangles) == "the mesh encloses nothing that a body could be");
  std::vector<Vec3> broken = placesOf(box);
  broken[3].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(told(broken, box.triangles) == "the mesh has places that are no numbers");
  const std::vector<Vec3> heap(box.positions.size(), Vec3(1.0));
  CHECK_FALSE(told(heap, box.triangles).empty());
}

TEST_CASE("Filling a body asks twice whether to go on, and stops where told", "[locators]") {
  const test::Shape box = test::box({2, 6, 2}, 1.0);
  for (const double last : {0.5, 0.8, 2.0}) {
    std::vector<double> asked;
    const Result<StandingBody> body =
        standingIn(placesOf(box), box.triangles, UpAxis::ofScene, [&](double share) {
          asked.push_back(share);
          return share < last;
        });
    CHECK(body.ok() == (last > 1.0));
    CHECK(asked == (last == 0.5 ? std::vector<double>{0.5} : std::vector<double>{0.5, 0.8}));
    if (!body) {
      CHECK(body.error().line() == "stopped before the locators were found; fit them again");
    }
  }
}

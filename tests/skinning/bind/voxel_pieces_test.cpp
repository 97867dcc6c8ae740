// Grids of cubes, what lines through them vote, and lines of bones in them: each against what is counted by
// hand.
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/bind/bone_lines.h"
#include "skinning/bind/points_within.h"
#include "skinning/bind/voxel_body.h"
#include "skinning/bind/voxel_lines.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

VoxelGrid unevenGrid() {
  return {Vec3(-1.0, 2.0, 10.0), 0.5, {3, 4, 5}};
}

/// A body of cubes 1 wide from the origin on: 10 along x, with 1 beside it in y and z all around left empty.
VoxelBody rowOfCubes() {
  VoxelBody body;
  body.grid = {Vec3(0.0), 1.0, {12, 3, 3}};
  body.cellAt.assign(body.grid.cubeCount(), VoxelBody::outside);
  for (int x = 1; x <= 10; ++x) {
    const std::size_t cube = body.grid.indexOf({x, 1, 1});
    body.cellAt[cube] = x - 1;
    body.cubeOf.push_back(static_cast<std::uint32_t>(cube));
    body.depths.push_back(static_cast<float>(x));
  }
  return body;
}

bool isPlace(const Vec3& is, const Vec3& wanted) {
  return glm::length(is - wanted) < 1e-9;
}

} // namespace

TEST_CASE("Cubes of a grid are counted each once, the last axis first, there and back") {
  const VoxelGrid grid = unevenGrid();
  CHECK(grid.cubeCount() == 60);
  std::size_t index = 0;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 5; ++z) {
        CHECK(grid.indexOf({x, y, z}) == index);
        CHECK(grid.placeOfIndex(index) == std::array<int, 3>{x, y, z});
        CHECK(grid.contains({x, y, z}));
        CHECK(isPlace(grid.middleOf({x, y, z}), Vec3(-0.75 + 0.5 * x, 2.25 + 0.5 * y, 10.25 + 0.5 * z)));
        CHECK(grid.placeOf(grid.middleOf({x, y, z})) == std::array<int, 3>{x, y, z});
        ++index;
      }
    }
  }
  for (const std::array<int, 3>& beyond :
       {std::array{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {3, 0, 0}, {0, 4, 0}, {0, 0, 5}}) {
    CHECK_FALSE(grid.contains(beyond));
  }
}

TEST_CASE(
    "A point lies in the cube that begins at or before it, and outside of the grid in the nearest one") {
  const VoxelGrid grid = unevenGrid();
  CHECK(grid.placeOf(Vec3(-1.0, 2.0, 10.0)) == std::array<int, 3>{0, 0, 0});
  CHECK(grid.placeOf(Vec3(-0.501, 2.5, 10.999)) == std::array<int, 3>{0, 1, 1});
  CHECK(grid.placeOf(Vec3(-0.5, 2.499, 11.0)) == std::array<int, 3>{1, 0, 2});
  CHECK(grid.placeOf(Vec3(-9.0, 99.0, 0.0)) == std::array<int, 3>{0, 3, 0});
  CHECK(grid.placeOf(Vec3(99.0, -9.0, 99.0)) == std::array<int, 3>{2, 0, 4});
}

TEST_CASE("The cell of a point is its own, or the nearest within so many cubes, or none") {
  const VoxelBody body = rowOfCubes();
  CHECK(body.cellCount() == 10);
  CHECK(isPlace(body.middleOf(3), Vec3(4.5, 1.5, 1.5)));
  CHECK(body.cellNear(Vec3(4.2, 1.9, 1.1), 0) == 3);
  CHECK(body.cellNear(Vec3(4.2, 0.5, 1.5), 0) == VoxelBody::outside);
  CHECK(body.cellNear(Vec3(4.2, 0.5, 1.5), 1) == 3);
  CHECK(body.cellNear(Vec3(4.2, 2.5, 0.1), 1) == 3);
  CHECK(body.cellNear(Vec3(4.95, 0.5, 1.5), 1) == 3);
  CHECK(body.cellNear(Vec3(5.05, 0.5, 1.5), 1) == 4);
  CHECK(body.cellNear(Vec3(0.5, 1.5, 1.5), 1) == 0);
  CHECK(body.cellNear(Vec3(11.5, 1.5, 1.5), 1) == 9);
}

TEST_CASE("Lines along three axes say of each cube whether they are inside of a body of cubes") {
  // An L that lies in space, cubes 2 wide, in a grid of the same cubes.
  const auto isFilled = [](int x, int y, int z) {
    return (x == 1 && y >= 1 && y < 4 && z == 2) || (y == 1 && x >= 1 && x < 5 && z == 2);
  };
  const test::Shape shape = test::cubes({0, 0, 0}, {7, 6, 5}, 2.0, isFilled);
  const VoxelGrid grid{Vec3(0.0), 2.0, {7, 6, 5}};
  const Cubes votes = votesOfLines(grid, shape.positions, shape.triangles);
  REQUIRE(votes.size() == grid.cubeCount());
  for (std::size_t cube = 0; cube < votes.size(); ++cube) {
    const auto [x, y, z] = grid.placeOfIndex(cube);
    INFO(x << " " << y << " " << z);
    CHECK(static_cast<int>(votes[cube]) == (isFilled(x, y, z) ? 3 : 0));
  }
}

TEST_CASE("A line that meets a hole says nothing, the other two still do") {
  test::Shape shape =
      test::cubes({0, 0, 0}, {3, 3, 3}, 1.0, [](int x, int y, int z) { return x == 1 && y == 1 && z == 1; });
  // Without the side towards +x.
  std::erase_if(shape.triangles, [&](const Triangle& triangle) {
    return std::ranges::all_of(triangle,
                               [&](std::uint32_t corner) { return shape.positions[corner].x > 1.5F; });
  });
  REQUIRE(shape.triangles.size() == 10);
  const VoxelGrid grid{Vec3(0.0), 1.0, {3, 3, 3}};
  const Cubes votes = votesOfLines(grid, shape.positions, shape.triangles);
  for (std::size_t cube = 0; cube < votes.size(); ++cube) {
    CHECK(static_cast<int>(votes[cube]) == (grid.placeOfIndex(cube) == std::array<int, 3>{1, 1, 1} ? 2 : 0));
  }
}

TEST_CASE("Points are told to lie within the shells around them, several where they are nested") {
  test::Shape all;
  std::vector<std::size_t> shells;
  // A large cube, a small one in it, and one beside both.
  const std::vector<std::pair<Vec3, float>> boxes{
      {Vec3(0.0), 10.0F}, {Vec3(4.03, 4.01, 4.02), 2.0F}, {Vec3(20.0, 0.0, 0.0), 10.0F}};
  for (const auto& [place, size] : boxes) {
    const test::Shape box = test::box({1, 1, 1}, 1.0);
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3& corner : box.positions) {
      all.positions.push_back(size * corner + glm::vec3(place));
      shells.push_back((all.positions.size() - 1) / 8);
    }
    for (const Triangle& t : box.triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  const std::vector<Vec3> points{
      {5.13, 5.07, 5.11}, {1.37, 2.13, 3.71}, {25.17, 5.23, 5.31}, {15.11, 5.07, 5.03}, {1.37, 2.13, -3.71}};
  const auto around = shellsAround(all.positions, all.triangles, shells, points);
  REQUIRE(around.size() == 5);
  using Shells = std::vector<std::size_t>;
  CHECK(around[0] == Shells{0, 1});
  CHECK(around[1] == Shells{0});
  CHECK(around[2] == Shells{2});
  CHECK(around[3].empty());
  CHECK(around[4].empty());
}

TEST_CASE("Bones run from joint to joint, and the last ones go on as the one before them came") {
  const std::vector<BindJoint> joints{
      {Vec3(0.0), -1}, {Vec3(1.0, 0.0, 0.0), 0}, {Vec3(1.0, 2.0, 0.0), 1}, {Vec3(0.0, 0.0, 3.0), 0}};
  std::vector<std::pair<Vec3, Vec3>> asked;
  const std::vector<BoneLine> lines = boneLines(joints, [&](const Vec3& place, const Vec3& along) {
    asked.emplace_back(place, along);
    return place + 2.0 * along;
  });
  REQUIRE(lines.size() == 5);
  const auto check = [&](std::size_t line, int joint, const Vec3& start, const Vec3& end, int endJoint) {
    INFO(line);
    CHECK(lines[line].joint == joint);
    CHECK(isPlace(lines[line].start, start));
    CHECK(isPlace(lines[line].end, end));
    CHECK(lines[line].endJoint == endJoint);
  };
  check(0, 0, Vec3(0.0), Vec3(1.0, 0.0, 0.0), 1);
  check(1, 1, Vec3(1.0, 0.0, 0.0), Vec3(1.0, 2.0, 0.0), 2);
  check(2, 0, Vec3(0.0), Vec3(0.0, 0.0, 3.0), 3);
  check(3, 2, Vec3(1.0, 2.0, 0.0), Vec3(1.0, 6.0, 0.0), -1);
  check(4, 3, Vec3(0.0, 0.0, 3.0), Vec3(0.0, 0.0, 9.0), -1);
  CHECK(asked.size() == 2);
  // A joint alone has no bone before it.
  const std::vector<BoneLine> alone = boneLines({{Vec3(7.0), -1}}, [](const Vec3& place, const Vec3& along) {
    CHECK(along == Vec3(0.0));
    return place;
  });
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].end == Vec3(7.0));
}

TEST_CASE("A bone whose direction is known leads there alone, and to no child that stands beside it") {
  const Vec3 up(0.0, 1.0, 0.0);
  const std::vector<BindJoint> joints{{Vec3(0.0), -1, up},
                                      {Vec3(0.1, 1.0, 0.0), 0, up},
                                      {Vec3(1.0, 0.0, 0.0), 0, Vec3(0.0, 0.0, 1.0)},
                                      {Vec3(2.0, 0.0, 1.0), 2}};
  const std::vector<BoneLine> lines =
      boneLines(joints, [](const Vec3& place, const Vec3& along) { return place + 2.0 * along; });
  REQUIRE(lines.size() == 4);
  // The first leads to the second, about, and not to the third.
  CHECK(lines[0].joint == 0);
  CHECK(lines[0].endJoint == 1);
  // One that leads to none of its children runs to all of them.
  CHECK(lines[1].joint == 2);
  CHECK(lines[1].endJoint == 3);
  // The last ones are asked for by bones as long as those before them, the second's in its own direction.
  CHECK(isPlace(lines[2].end, Vec3(0.1, 1.0 + 2.0 * std::hypot(0.1, 1.0), 0.0)));
  CHECK(isPlace(lines[3].end, Vec3(4.0, 0.0, 3.0)));
}

TEST_CASE("A short thick bone that begins deep in the body takes nothing of what lies about its joint") {
  // Cubes get deeper along the row: 1, 2 ... 10. A bone from 2 to 4 with a child beside its line.
  const VoxelBody body = rowOfCubes();
  const Vec3 side(1.0, 0.0, 0.0);
  const auto waysTo = [&](double from, double to) {
    const std::vector<BoneLine> lines = boneLines(body, {{Vec3(2.5, 1.5, 1.5), -1, Vec3(0.0, 1.0, 0.0)},
                                                         {Vec3(2.5, 2.5, 1.5), 0},
                                                         {Vec3(from, 1.5, 1.5), 0, side},
                                                         {Vec3(to, 1.5, 1.5), 2, side}});
    return std::ranges::count_if(lines, [](const BoneLine& line) { return line.endJoint == 2; });
  };
  CHECK(waysTo(9.5, 5.5) == 1); // from the depth 9 to 5: 4 long, 7 thick
  CHECK(waysTo(5.5, 9.5) == 0); // it begins where the body is thinner
  CHECK(waysTo(4.5, 4.5) == 0); // as deep as it is thick
}

TEST_CASE("A last bone goes on for eight tenths of what is left of the body, a quarter of the body at most") {
  const VoxelBody body = rowOfCubes();
  const auto endFrom = [&](double x, double before) {
    return boneLines(body, {{Vec3(before, 1.5, 1.5), -1}, {Vec3(x, 1.5, 1.5), 0}}).back().end;
  };
  // 12 cubes: a quarter is 3. From 9 on there are 2 left, found in steps of half a cube.
  CHECK(isPlace(endFrom(9.0, 5.0), Vec3(9.0 + 0.8 * 2.0, 1.5, 1.5)));
  CHECK(isPlace(endFrom(4.0, 2.0), Vec3(4.0 + 0.8 * 3.0, 1.5, 1.5)));
  CHECK(isPlace(endFrom(2.0, 5.0), Vec3(2.0 - 0.8 * 1.5, 1.5, 1.5)));
  CHECK(isPlace(endFrom(5.0, 5.0), Vec3(5.0, 1.5, 1.5)));
}

TEST_CASE(
    "A bone passes the cells that it runs through, at most half a cube apart, with how far it is from them") {
  const VoxelBody body = rowOfCubes();
  const std::vector<BoneCell> cells = boneCells(
      body, {{0, Vec3(1.5, 1.5, 1.5), Vec3(3.5, 1.5, 1.5)}, {2, Vec3(5.5, 1.25, 1.5), Vec3(5.5, 1.25, 1.5)}});
  REQUIRE(cells.size() == 7);
  for (std::size_t i = 0; i < 5; ++i) {
    INFO(i);
    CHECK(cells[i].line == 0);
    CHECK(cells[i].along == Approx(0.25 * static_cast<double>(i)));
  }
  CHECK(cells[0].cell == 0);
  CHECK(cells[0].distance == Approx(0.0).margin(1e-12));
  CHECK(cells[1].cell == 1);
  CHECK(cells[1].distance == Approx(0.5));
  CHECK(cells[4].cell == 2);
  // The bone without length is one place, met at its start and at its end.
  CHECK(cells[5].line == 1);
  CHECK(cells[6].cell == 4);
  CHECK(cells[6].distance == Approx(0.25));
}

TEST_CASE("A bone is as thick as the middle of the depths that it passes, one cube where it passes none") {
  const VoxelBody body = rowOfCubes(); // as deep as the number of the cell and one
  const std::vector<BoneLine> lines{
      {0, Vec3(0.0), Vec3(0.0)}, {2, Vec3(0.0), Vec3(0.0)}, {0, Vec3(0.0), Vec3(0.0)}};
  const std::vector<BoneCell> cells{{8, 0}, {0, 0}, {4, 2}, {6, 1}};
  CHECK(boneRadii(body, lines, cells, 3) == std::vector<double>{5.0, 1.0, 7.0});
  CHECK(boneRadii(body, lines, {}, 2) == std::vector<double>{1.0, 1.0});
}

TEST_CASE("A body of cubes is its surface and what that encloses, with how deep each cell lies") {
  const test::Shape shape = test::box({1, 1, 1}, 4.0);
  const auto body = voxelBody(shape.positions, shape.triangles, 8);
  REQUIRE(body);
  CHECK(body->depths.size() == body->cellCount());
  const std::int32_t middle = body->cellNear(Vec3(2.0), 0);
  REQUIRE(middle != VoxelBody::outside);
  const float deepest = body->depths[static_cast<std::size_t>(middle)];
  CHECK(deepest == Approx(2.0).margin(2.0 * body->grid.size));
  for (const float depth : body->depths) {
    CHECK(depth > 0.0F);
    CHECK(depth <= deepest + static_cast<float>(body->grid.size));
  }
  for (const Vec3& corner : {Vec3(0.01), Vec3(3.99), Vec3(0.01, 3.99, 2.0)}) {
    CHECK(body->cellNear(corner, 0) != VoxelBody::outside);
  }
  CHECK(body->cellNear(Vec3(-2.0 * body->grid.size, 2.0, 2.0), 0) == VoxelBody::outside);
}

TEST_CASE("A mesh without extent, or at places that are no numbers, is no body") {
  const std::vector<Triangle> one{{0, 1, 2}};
  CHECK_FALSE(voxelBody(std::vector<glm::vec3>{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, one, 16));
  CHECK_FALSE(voxelBody(std::vector<glm::vec3>{{0, 0, 0}, {1, 1, 1}}, {}, 16));
  const float odd = std::numeric_limits<float>::infinity();
  CHECK_FALSE(voxelBody(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, odd, 0}}, one, 16));
  CHECK(voxelBody(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, one, 16));
}

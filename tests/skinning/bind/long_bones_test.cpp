// Bones far longer than their body, beside it and through it, and twist joints among their siblings.
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "skinning/bind/bone_lines.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A solid box from 0 to 4, in cubes.
VoxelBody solid() {
  const test::Shape shape = test::box({1, 1, 1}, 4.0);
  Result<VoxelBody> body = voxelBody(shape.positions, shape.triangles, 32);
  REQUIRE(body);
  return std::move(body).value();
}

std::set<std::size_t> cellsOf(const VoxelBody& body, const Vec3& start, const Vec3& end) {
  std::set<std::size_t> cells;
  for (const BoneCell& cell : boneCells(body, {{0, start, end}})) {
    cells.insert(cell.cell);
  }
  return cells;
}

} // namespace

TEST_CASE("A bone of any length meets the cells that its part within the body meets, at the same places") {
  const VoxelBody body = solid();
  const Vec3 low = body.grid.origin;
  const Vec3 high =
      low + body.grid.size * Vec3(body.grid.counts[0], body.grid.counts[1], body.grid.counts[2]);
  const Vec3 middle = 0.5 * (low + high);
  for (const Vec3& way : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 1.0)}) {
    CAPTURE(way.x, way.y, way.z);
    const std::set<std::size_t> near = cellsOf(body, middle - 3.0 * way, middle + 3.0 * way);
    CHECK(near.size() > 20);
    for (const double far : {3e3, 1e5}) {
      CHECK(cellsOf(body, middle - far * way, middle + far * way) == near);
      CHECK(cellsOf(body, middle - 3.0 * way, middle + far * way) == near);
      CHECK(cellsOf(body, middle - far * way, middle + 3.0 * way) == near);
      // Away from it none, be it beside the body, before it or past it.
      const Vec3 beside = middle + 40.0 * glm::normalize(glm::cross(way, Vec3(0.3, 0.5, 0.8)));
      CHECK(cellsOf(body, beside - far * way, beside + far * way).empty());
      CHECK(cellsOf(body, middle + 20.0 * way, middle + far * way).empty());
      CHECK(cellsOf(body, middle - far * way, middle - 20.0 * way).empty());
      // Places along it, from 0 at its start to 1 at its end.
      for (const BoneCell& cell : boneCells(body, {{0, middle - far * way, middle + 2.0 * far * way}})) {
        CHECK(static_cast<double>(cell.along) == Approx(1.0 / 3.0).margin(3.0 / far));
        CHECK(cell.distance < 5.0 * body.grid.size);
      }
    }
  }
}

TEST_CASE(
    "A level bone far longer than a body meets nothing of it above, below or beside its box, however near") {
  const VoxelBody body = solid();
  const Vec3 extent = body.grid.size * Vec3(body.grid.counts[0], body.grid.counts[1], body.grid.counts[2]);
  const Vec3 middle = body.grid.origin + 0.5 * extent;
  for (const std::size_t along : {0U, 1U, 2U}) {
    for (const std::size_t off : {(along + 1) % 3, (along + 2) % 3}) {
      for (const double side : {-1.0, 1.0}) {
        CAPTURE(along, off, side);
        Vec3 way(0.0);
        way[along] = 3e3;
        Vec3 place = middle;
        place[off] += side * (0.5 * extent[off] - 1.5 * body.grid.size);
        CHECK_FALSE(cellsOf(body, place - way, place + way).empty());
        place[off] += side * 2.0 * body.grid.size;
        CHECK(cellsOf(body, place - way, place + way).empty());
      }
    }
  }
}

TEST_CASE("A bone that crosses a body aslant meets as many cells however far it goes on") {
  const VoxelBody body = solid();
  const Vec3 middle =
      body.grid.origin +
      0.5 * body.grid.size * Vec3(body.grid.counts[0], body.grid.counts[1], body.grid.counts[2]);
  const Vec3 way = glm::normalize(Vec3(1.0, 0.6, -0.4));
  const auto near = static_cast<double>(cellsOf(body, middle - 3.0 * way, middle + 3.0 * way).size());
  for (const double far : {3e3, 1e5}) {
    const std::set<std::size_t> cells = cellsOf(body, middle - far * way, middle + far * way);
    CHECK(static_cast<double>(cells.size()) > 0.8 * near);
    CHECK(static_cast<double>(cells.size()) < 1.2 * near);
  }
}

TEST_CASE("A bone meets the cells of both of its ends, also where it is no longer than a cube") {
  const VoxelBody body = solid();
  const Vec3 middle =
      body.grid.origin +
      0.5 * body.grid.size * Vec3(body.grid.counts[0], body.grid.counts[1], body.grid.counts[2]);
  for (const double length : {0.0, 0.3, 1.0, 7.3}) {
    const Vec3 end = middle + length * body.grid.size * Vec3(0.0, 1.0, 0.0);
    const std::vector<BoneCell> cells = boneCells(body, {{0, middle, end}});
    REQUIRE(cells.size() >= 2);
    CHECK(cells.front().along == 0.0F);
    CHECK(cells.back().along == 1.0F);
    CHECK(cells.front().cell == static_cast<std::size_t>(body.cellNear(middle, 0)));
    CHECK(cells.back().cell == static_cast<std::size_t>(body.cellNear(end, 0)));
  }
}

TEST_CASE("A last joint on the way to a sibling that goes on is a twist of the bone to it, else an end") {
  const auto endOf = [](const Vec3& twist, int parent, bool goesOn) {
    std::vector<BindJoint> joints{
        {Vec3(0.0), -1}, {Vec3(0.0, 1.0, 0.0), 0}, {twist, parent}, {Vec3(2.0, 1.0, 0.0), 1}};
    if (goesOn) {
      joints.push_back({Vec3(3.0, 1.0, 0.0), 3});
    }
    for (const BoneLine& line : boneLines(joints, [](const Vec3&, const Vec3&) { return Vec3(77.0); })) {
      if (line.joint == 2) {
        return line.end;
      }
    }
    return Vec3(0.0);
  };
  CHECK(endOf(Vec3(1.0, 1.0, 0.0), 1, true) == Vec3(2.0, 1.0, 0.0));
  CHECK(endOf(Vec3(1.0, 1.1, 0.0), 1, true) == Vec3(2.0, 1.0, 0.0)); // nearly
  CHECK(endOf(Vec3(1.0, 1.5, 0.0), 1, true) == Vec3(77.0));          // to the side
  CHECK(endOf(Vec3(2.5, 1.0, 0.0), 1, true) == Vec3(77.0));          // past it
  CHECK(endOf(Vec3(1.0, 1.0, 0.0), 1, false) == Vec3(77.0));         // the sibling ends there, too
  CHECK(endOf(Vec3(1.0, 0.5, 0.0), 0, true) == Vec3(77.0));          // no sibling of it
}

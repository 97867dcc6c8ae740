// What is read of creatures of tubes, and pieces of that: places along lines, parts of bodies, ends in pairs.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/polyline.h"
#include "skinning/locate/creature/body_branches.h"
#include "skinning/locate/creature/creature_ends.h"
#include "skinning/locate/creature/creature_shape.h"
#include "skinning/locate/creature/joints_along.h"
#include "tests/support/recorded.h"
#include "tests/support/skinning/cube_bodies.h"
#include "tests/support/skinning/tube_creature.h"

using namespace stretch;
using namespace stretch::skinning;
using test::TubePerson;

namespace {

struct Creature {
  std::string title;
  TubePerson body;
};

std::vector<Creature> creatures() {
  return {{"quadruped", test::tubeQuadruped()}, {"quadruped without a tail", test::tubeQuadruped(false)},
          {"bird", test::tubeBird()},           {"insect", test::tubeInsect(3)},
          {"spider", test::tubeInsect(4)},      {"of five rows", test::tubeInsect(5)},
          {"stooping", test::tubeStooping()},   {"person", test::tubePerson({.armsDown = 0.5})}};
}

CreatureShape shapeOf(const TubePerson& body) {
  const Result<CreatureShape> shape = shapeOfMesh(body.positions, body.triangles, 0, UpAxis::ofScene, {});
  REQUIRE(shape);
  return *shape;
}

std::string shapeText(const std::string& title, const CreatureShape& shape) {
  std::string text = fmt::format("{} : {} rows , lies {} , stands {}\n", title, shape.legRows,
                                 shape.trunkLies, shape.trunkStands);
  for (const CreatureLimb& limb : shape.limbs) {
    text += fmt::format("  part {} side {} row {} , {:.3f} sure , {} places :", static_cast<int>(limb.part),
                        limb.side, limb.row, limb.confidence, limb.line.size());
    const std::size_t step = std::max<std::size_t>(1, limb.line.size() / 8);
    for (std::size_t i = 0; i < limb.line.size(); i += step) {
      text += fmt::format(" {:.4f} {:.4f} {:.4f} ,", limb.line[i].x, limb.line[i].y, limb.line[i].z);
    }
    text += "\n";
  }
  return text;
}

const CreatureLimb* limbOf(const CreatureShape& shape, CreaturePart part, int side, int row) {
  const auto found = std::ranges::find_if(shape.limbs, [&](const CreatureLimb& limb) {
    return limb.part == part && limb.side == side && limb.row == row;
  });
  return found == shape.limbs.end() ? nullptr : &*found;
}

} // namespace

TEST_CASE(
    "What shapes of creatures are read as, with rows that are given and without, is as it was looked at",
    "[locators]") {
  std::string text;
  for (const Creature& creature : creatures()) {
    const Result<StandingBody> body =
        standingIn(creature.body.positions, creature.body.triangles, UpAxis::ofScene, {});
    REQUIRE(body);
    for (const int rows : {0, 1, 2, 3, 4}) {
      text += shapeText(fmt::format("{} , {} rows asked", creature.title, rows), creatureShape(*body, rows));
    }
  }
  test::compareWithRecord("shapes-of-creatures", text, 1e-3);
}

TEST_CASE("Legs of creatures come in pairs, row by row from the front, as far out as they were made",
          "[locators]") {
  for (const auto& [rows, body] : {std::pair{2, test::tubeQuadruped()},
                                   {1, test::tubeBird()},
                                   {3, test::tubeInsect(3)},
                                   {4, test::tubeInsect(4)}}) {
    const CreatureShape shape = shapeOf(body);
    CHECK(shape.legRows == rows);
    CHECK(shape.trunkLies);
    CHECK_FALSE(shape.trunkStands);
    double before = 1e9;
    for (int row = 1; row <= rows; ++row) {
      const CreatureLimb* const left = limbOf(shape, CreaturePart::leg, 1, row);
      const CreatureLimb* const right = limbOf(shape, CreaturePart::leg, -1, row);
      CAPTURE(rows, row);
      REQUIRE(left != nullptr);
      REQUIRE(right != nullptr);
      CHECK(left->line.back().z < before);
      before = left->line.back().z;
      CHECK(glm::distance(left->line.back(), Vec3(-1, 1, 1) * right->line.back()) < 0.06);
      CHECK(glm::distance(left->line.front(), Vec3(-1, 1, 1) * right->line.front()) < 0.06);
      CHECK(left->line.back().y < left->line.front().y);
      CHECK(left->line.back().x > 0.0);
    }
    CHECK(limbOf(shape, CreaturePart::leg, 1, rows + 1) == nullptr);
  }
  CHECK(limbOf(shapeOf(test::tubeQuadruped()), CreaturePart::tail, 0, 0) != nullptr);
  CHECK(limbOf(shapeOf(test::tubeQuadruped(false)), CreaturePart::tail, 0, 0) == nullptr);
  CHECK(limbOf(shapeOf(test::tubeBird()), CreaturePart::wing, 1, 0) != nullptr);
  CHECK(shapeOf(test::tubePerson({.armsDown = 0.5})).trunkStands);
}

TEST_CASE("Joints stand at the given parts of a straight line, and at bends where these are near",
          "[locators]") {
  std::vector<Vec3> straight;
  for (int i = 0; i <= 100; ++i) {
    straight.emplace_back(0.02 * i, 1.0, -0.01 * i);
  }
  const std::vector<double> parts{0.0, 0.3, 0.65, 1.0};
  const std::vector<Vec3> even = jointsAlong(straight, parts);
  REQUIRE(even.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(glm::distance(even[i], straight.front() + parts[i] * (straight.back() - straight.front())) < 0.03);
  }
  std::vector<Vec3> bent; // 0.4 along x, then up
  for (int i = 0; i <= 100; ++i) {
    bent.push_back(i < 40 ? Vec3(0.01 * i, 0.0, 0.0) : Vec3(0.4, 0.01 * (i - 40), 0.0));
  }
  const std::vector<Vec3> joints = jointsAlong(bent, {0.0, 0.45, 1.0});
  REQUIRE(joints.size() == 3);
  CHECK(joints[0] == bent.front());
  CHECK(joints[2] == bent.back());
  CHECK(glm::distance(joints[1], Vec3(0.4, 0.0, 0.0)) < 0.02);
}

TEST_CASE("A line is parted evenly along its own length, its ends exact", "[locators]") {
  const std::vector<Vec3> line{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {3, 4, 1}};
  for (const std::size_t count : {2U, 3U, 9U, 33U}) {
    const std::vector<Vec3> places = evenly(line, count);
    REQUIRE(places.size() == count);
    CHECK(glm::distance(places.front(), line.front()) < 1e-9);
    CHECK(glm::distance(places.back(), line.back()) < 1e-9);
    for (std::size_t i = 0; i < count; ++i) {
      const double way = 8.0 * static_cast<double>(i) / static_cast<double>(count - 1);
      const Vec3 wanted = way <= 3.0   ? Vec3(way, 0, 0)
                          : way <= 7.0 ? Vec3(3, way - 3.0, 0)
                                       : Vec3(3, 4, way - 7.0);
      CHECK(glm::distance(places[i], wanted) < 1e-6);
    }
  }
}

namespace {

/// Rows of cubes from one in the middle: so many to +x and -x, up, down, to +z and -z.
StandingBody crossOf(const std::array<int, 6>& rows) {
  const glm::ivec3 middle(rows[1], rows[3], rows[5]);
  const glm::ivec3 counts(rows[0] + rows[1] + 1, rows[2] + rows[3] + 1, rows[4] + rows[5] + 1);
  return test::bodyOfCubes(counts, 1.0, Vec3(-0.5) - Vec3(middle), [=](int x, int y, int z) {
    return (x == middle.x) + (y == middle.y) + (z == middle.z) >= 2;
  });
}

} // namespace

TEST_CASE("Every cell of a cross belongs to the end of its own row, from the tip inwards", "[locators]") {
  const StandingBody body = crossOf({8, 8, 5, 0, 7, 6});
  const std::vector<double> ways =
      test::waysByRounds(body.cubes, {static_cast<std::uint32_t>(body.cubes.cellNear(Vec3(0.0), 0))});
  const std::vector<BodyEnd> ends = bodyEnds(body, ways, 0.2);
  const std::vector<BodyBranch> branches = branchesOf(body, ways, ends);
  REQUIRE(branches.size() == ends.size());
  REQUIRE(ends.size() == 5);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    CHECK(branches[i].tip == ends[i].cell);
    REQUIRE_FALSE(branches[i].cells.empty());
    CHECK(branches[i].cells.front() == ends[i].cell);
    const Vec3 tip = glm::normalize(body.middleOf(ends[i].cell));
    double before = 1e9;
    for (const std::uint32_t cell : branches[i].cells) {
      const Vec3 place = body.middleOf(cell);
      CHECK(ways[cell] <= before);
      before = ways[cell];
      CHECK((glm::length(place) < 1.1 || glm::dot(place, tip) == Approx(glm::length(place))));
    }
    CHECK(branches[i].cells.size() >= static_cast<std::size_t>(ends[i].length) - 1);
  }
}

TEST_CASE("Sections of a branch are two cubes long, with their middle and the disc of their cells",
          "[locators]") {
  const StandingBody body = test::bodyOfCubes({12, 2, 3}, 0.5, Vec3(0.0),
                                              [](int x, int y, int z) { return x < 6 || (y == 0 && z < 2); });
  std::vector<std::uint32_t> cells;
  std::vector<double> fromTip;
  for (std::uint32_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    cells.push_back(cell);
    fromTip.push_back(5.75 - body.middleOf(cell).x); // by layers
  }
  std::ranges::stable_sort(cells, [&](std::uint32_t a, std::uint32_t b) { return fromTip[a] < fromTip[b]; });
  const std::vector<BranchSection> sections = sectionsOf(body, cells, fromTip);
  REQUIRE(sections.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const double across = i < 3 ? 2.0 : 6.0;
    CHECK(sections[i].radius == Approx(0.5 * std::sqrt(across / pi)));
    CHECK(sections[i].middle.x == Approx(5.5 - static_cast<double>(i)));
    CHECK(sections[i].middle.y == Approx(i < 3 ? 0.25 : 0.5));
    CHECK(sections[i].middle.z == Approx(i < 3 ? 0.5 : 0.75));
  }
}

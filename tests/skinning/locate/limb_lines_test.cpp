// Legs and arms in bodies of cubes: their sections, where they begin and end, each against what is counted.
#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/locate/arm_joints.h"
#include "skinning/locate/arm_line.h"
#include "skinning/locate/leg_lines.h"
#include "tests/support/skinning/cube_bodies.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr double far = 1e300;

/// A figure of 128 layers, 20 cubes wide and 9 deep: legs of 7 by 5 cubes to layer 64, a trunk above.
/// `leg(side, y, place)`: shifts a leg in x and z or leaves it out of a layer.
struct Figure {
  std::function<std::optional<glm::ivec2>(int side, int y)> leg = [](int, int) {
    return std::optional(glm::ivec2(0));
  };
  std::function<bool(int x, int y, int z)> more = [](int, int, int) { return false; };
};

constexpr double cube = 1.0 / 128.0;

bool isInLeg(const Figure& figure, int side, int x, int y, int z) {
  const std::optional<glm::ivec2> shift = figure.leg(side, y);
  const int first = side < 0 ? 1 : 12;
  return y < 64 && shift && x >= first + shift->x && x < first + 7 + shift->x && z >= 2 + shift->y &&
         z < 7 + shift->y;
}

StandingBody standing(const Figure& figure) {
  return test::bodyOfCubes(
      {20, 128, 9}, cube, Vec3(-10.0 * cube, 0.0, -4.5 * cube), [&](int x, int y, int z) {
        return y >= 64 || isInLeg(figure, -1, x, y, z) || isInLeg(figure, 1, x, y, z) || figure.more(x, y, z);
      });
}

double heightOf(int layer) {
  return (layer + 0.5) * cube;
}

/// That a body has legs up to a layer, or none where that is 0.
void checkLegsTo(const Figure& figure, int top) {
  const LegLines legs = legLines(standing(figure));
  CHECK(legs.found() == (top > 0));
  if (legs.found()) {
    CHECK(legs.left.back().height == Approx(heightOf(top - 1)));
    CHECK(legs.right.back().height == Approx(heightOf(top - 1)));
    CHECK(legs.crotch == Approx(heightOf(top)));
  }
}

} // namespace

TEST_CASE("Sections of legs are the middle, area and reach of each layer, and their cells are told",
          "[locators]") {
  Figure figure;
  figure.more = [](int x, int y, int z) { return y < 4 && z >= 7 && x != 0 && x != 19 && (x < 8 || x > 11); };
  const StandingBody body = standing(figure); // feet to the front, as wide as the legs
  const LegLines legs = legLines(body);
  REQUIRE(legs.left.size() == 64);
  REQUIRE(legs.right.size() == 64);
  for (int y = 0; y < 64; ++y) {
    for (const int side : {-1, 1}) {
      const LegSection& section = (side < 0 ? legs.right : legs.left)[static_cast<std::size_t>(y)];
      const double depth = y < 4 ? 7.0 : 5.0;
      const double middle = -2.5 * cube + 0.5 * depth * cube;
      CHECK(section.height == Approx(heightOf(y)));
      CHECK(glm::distance(section.middle, Vec3(side * 5.5 * cube, heightOf(y), middle)) < 1e-9);
      CHECK(section.area == Approx(7.0 * depth * cube * cube));
      CHECK(section.front == Approx(0.5 * (depth - 1.0) * cube));
      CHECK(section.back == Approx(0.5 * (depth - 1.0) * cube));
    }
  }
  CHECK(legs.crotch == Approx(heightOf(64)));
  REQUIRE(legs.isLeg.size() == body.cubes.cellCount());
  for (std::size_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    CHECK(legs.isLeg[cell] == (body.middleOf(cell).y < heightOf(63) + 0.1 * cube));
  }
}

TEST_CASE("The larger of what is on a side of the ground is its foot", "[locators]") {
  Figure figure;
  figure.more = [](int x, int y, int z) { return y < 30 && x == 19 + 0 * z && z >= 7; }; // a stick
  figure.leg = [](int side, int) { return std::optional(glm::ivec2(side > 0 ? -2 : 0, 0)); };
  const LegLines legs = legLines(standing(figure));
  REQUIRE(legs.found());
  for (const LegSection& section : legs.left) {
    CHECK(section.middle.x == Approx(3.5 * cube));
  }
}

TEST_CASE("A leg goes on over as many as fourteen layers without it, and not over more", "[locators]") {
  const auto gap = [](int from, int layers, int side) {
    Figure figure;
    figure.leg = [=](int of, int y) {
      return (side == 0 || of == side) && y >= from && y < from + layers ? std::nullopt
                                                                         : std::optional(glm::ivec2(0));
    };
    return figure;
  };
  for (const int side : {-1, 0, 1}) {
    checkLegsTo(gap(20, 1, side), 64);
    checkLegsTo(gap(20, 14, side), 64);
    checkLegsTo(gap(20, 15, side), 20);
  }
}

TEST_CASE("A leg goes on in what lies near it, nearer yet over a gap", "[locators]") {
  const auto wide = [](int from, int shift) { // one thin leg that steps aside on each side
    return test::bodyOfCubes({40, 128, 3}, cube, Vec3(-20.0 * cube, 0.0, -1.5 * cube),
                             [=](int x, int y, int) {
                               const int place = y < from ? 0 : shift;
                               return y >= 64 || x == 3 + place || x == 36 - place;
                             });
  };
  CHECK(legLines(wide(20, 7)).left.back().height == Approx(heightOf(63))); // 0.055 of the height
  CHECK(legLines(wide(20, 8)).left.back().height == Approx(heightOf(19))); // 0.0625
  const auto overGap = [&](int shift) {
    return test::bodyOfCubes({40, 128, 3}, cube, Vec3(-20.0 * cube, 0.0, -1.5 * cube),
                             [=](int x, int y, int) {
                               const int place = y < 20 ? 0 : shift;
                               return y >= 64 || ((y < 18 || y >= 20) && (x == 3 + place || x == 36 - place));
                             });
  };
  CHECK(legLines(overGap(1)).right.back().height == Approx(heightOf(63))); // 0.0078
  CHECK(legLines(overGap(2)).right.back().height == Approx(heightOf(17))); // 0.0156
}

TEST_CASE("Thighs that touch by less than half of their depth are two legs yet", "[locators]") {
  const auto web = [](int depth) {
    Figure figure;
    figure.more = [=](int x, int y, int z) { return y >= 30 && x >= 8 && x < 12 && z >= 2 && z < 2 + depth; };
    return figure;
  };
  for (const int depth : {1, 2, 3}) { // of 5 cubes, so up to 0.5 between their middles
    checkLegsTo(web(depth), 64);
  }
  for (const int depth : {4, 5}) {
    checkLegsTo(web(depth), 30);
  }
  // Each has its half of what joins them.
  const LegLines legs = legLines(standing(web(2)));
  const double cells = 35.0 + 4.0;
  CHECK(legs.left[40].area == Approx(cells * cube * cube));
  CHECK(legs.right[40].area == Approx(cells * cube * cube));
  CHECK(legs.left[40].middle.x == Approx((35.0 * 5.5 + 4.0 * 1.0) / cells * cube));
  CHECK(legs.right[40].middle.x == Approx(-(35.0 * 5.5 + 4.0 * 1.0) / cells * cube));
}

TEST_CASE("Feet that are one belong to each leg by half, as high as legs begin", "[locators]") {
  const auto base = [](int layers) {
    Figure figure;
    figure.more = [=](int, int y, int) { return y < layers; };
    return figure;
  };
  const StandingBody body = standing(base(6));
  const LegLines legs = legLines(body);
  REQUIRE(legs.left.size() == 64);
  for (std::size_t y = 0; y < 6; ++y) {
    CHECK(legs.left[y].area == Approx(90.0 * cube * cube));
    CHECK(glm::distance(legs.left[y].middle, Vec3(5.0 * cube, heightOf(static_cast<int>(y)), 0.0)) < 1e-9);
    CHECK(glm::distance(legs.right[y].middle, Vec3(-5.0 * cube, heightOf(static_cast<int>(y)), 0.0)) < 1e-9);
    CHECK(legs.left[y].front == Approx(4.0 * cube));
    CHECK(legs.right[y].back == Approx(4.0 * cube));
  }
  CHECK(std::ranges::count(legs.isLeg, true) == 6 * 180 + 58 * 70);
  checkLegsTo(base(14), 64); // the next layer's middle is at 0.113 of the height
  checkLegsTo(base(15), 0);  // at 0.121
}

TEST_CASE("Legs that part lower than six hundredths of the height are none", "[locators]") {
  const auto low = [](int from) {
    Figure figure;
    figure.more = [=](int, int y, int) { return y >= from; };
    return figure;
  };
  checkLegsTo(low(9), 9); // the last section's middle is at 0.066
  checkLegsTo(low(8), 0); // at 0.059
}

TEST_CASE("A body stands on what touches the ground apart, without what is thin", "[locators]") {
  const auto onLegs = [](int thick, int thin, int widthOfThin) {
    return test::bodyOfCubes({64, 128, 8}, cube, Vec3(0.0), [=](int x, int y, int z) {
      const int leg = x / 9;
      const int across = x % 9;
      const bool isThin = leg >= thick && leg < thick + thin;
      return y >= 30 || (leg < thick && across < 8) || (isThin && across < widthOfThin && z < widthOfThin);
    });
  };
  for (const int legs : {1, 2, 4, 6}) {
    CHECK(legsUnder(onLegs(legs, 0, 0)) == static_cast<std::size_t>(legs));
  }
  CHECK(legsUnder(onLegs(2, 3, 4)) == 5); // 16 of 64 cells are a quarter
  CHECK(legsUnder(onLegs(2, 3, 3)) == 2);
  CHECK(legsUnder(test::bodyOfCubes({2, 3, 2}, 0.4, Vec3(0.0), [](int, int, int) { return true; })) == 0);
}

TEST_CASE("Legs are counted between feet and knees alone, and bridges are none", "[locators]") {
  const auto between = [](int from, int to) { // four legs in some layers, two in the others
    return test::bodyOfCubes({39, 128, 8}, cube, Vec3(0.0), [=](int x, int y, int) {
      return y >= 30 || (x % 10 < 8 && (x < 19 || (y >= from && y < to)));
    });
  };
  // Middles of layers 5 to 18 lie from 0.043 to 0.145 of the height: 14, of which the eighth, by size,
  // counts.
  CHECK(legsUnder(between(5, 12)) == 4);
  CHECK(legsUnder(between(6, 12)) == 2);
  CHECK(legsUnder(between(12, 19)) == 4);
  CHECK(legsUnder(between(13, 30)) == 2);
  CHECK(legsUnder(between(0, 11)) == 2);
  StandingBody body = between(5, 12);
  body.ownCells = 0;
  CHECK(legsUnder(body) == 4); // nothing is thinner than nothing
}

namespace {

/// A trunk of 10 by 60 by 8 cubes with arms sideways at layer 48, so many cubes long, thick and deep.
struct Armed {
  int right = 24;
  int left = 24;
  int thick = 4;
};

StandingBody armed(const Armed& arms) {
  constexpr int half = 40;
  return test::bodyOfCubes(
      {2 * half, 60, 8}, 1.0 / 64.0, Vec3(-half / 64.0, 0.0, -4.0 / 64.0), [=](int x, int y, int z) {
        const bool isTrunk = x >= half - 5 && x < half + 5;
        const bool isArm = x >= half - 5 - arms.right && x < half + 5 + arms.left && y >= 48 &&
                           y < 48 + arms.thick && z >= 2 && z < 2 + arms.thick;
        return isTrunk || isArm;
      });
}

LegLines noLegs(const StandingBody& body) {
  LegLines legs;
  legs.isLeg.assign(body.cubes.cellCount(), false);
  return legs;
}

std::vector<std::uint32_t> nearMiddle(const StandingBody& body, const LegLines& legs) {
  std::vector<std::uint32_t> cells;
  for (std::uint32_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    if (std::abs(body.middleOf(cell).x) < 1.5 * body.cubes.grid.size && !legs.isLeg[cell]) {
      cells.push_back(cell);
    }
  }
  return cells;
}

/// Heaps of two cubes along the way from the tip: mean place and the radius of a disc as large.
std::vector<ArmSection> heaped(const StandingBody& body, const std::vector<std::pair<Vec3, double>>& places) {
  const double size = body.cubes.grid.size;
  std::map<int, std::vector<Vec3>> heaps;
  for (const auto& [place, way] : places) {
    heaps[static_cast<int>(std::floor(std::max(way, 0.0) / (2.0 * size)))].push_back(place);
  }
  std::vector<ArmSection> sections;
  for (const auto& [number, heap] : heaps) {
    Vec3 sum(0.0);
    for (const Vec3& place : heap) {
      sum += place;
    }
    const auto count = static_cast<double>(heap.size());
    sections.push_back({(number + 0.5) * 2.0 * size, sum / count, std::sqrt(count * size * size / 2.0 / pi)});
  }
  return sections;
}

void checkSections(const std::vector<ArmSection>& is, const std::vector<ArmSection>& wanted) {
  REQUIRE(is.size() == wanted.size());
  for (std::size_t i = 0; i < is.size(); ++i) {
    CHECK(is[i].way == Approx(wanted[i].way));
    CHECK(glm::distance(is[i].middle, wanted[i].middle) < 1e-9);
    CHECK(is[i].radius == Approx(wanted[i].radius));
  }
}

} // namespace

TEST_CASE("Ways from the middle of a body go round its legs, and do not begin in them", "[locators]") {
  const StandingBody body = armed({});
  LegLines legs = noLegs(body);
  for (std::size_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    legs.isLeg[cell] = body.middleOf(cell).y < 0.4;
  }
  const std::vector<double> ways = waysFromMiddle(body, legs);
  const std::vector<double> expected = test::waysByRounds(body.cubes, nearMiddle(body, legs));
  REQUIRE(ways.size() == expected.size());
  bool areSame = true;
  for (std::size_t cell = 0; cell < ways.size(); ++cell) {
    areSame = areSame && std::abs(ways[cell] - expected[cell]) < 1e-9;
  }
  CHECK(areSame);
}

TEST_CASE("Ways from the middle begin in every cell of it, the first of the body among them", "[locators]") {
  for (const int before : {0, 1, 2}) {
    const StandingBody body = test::bodyOfCubes({9, 4, 3}, 1.0 / 64.0, Vec3(-before / 64.0, 0.0, 0.0),
                                                [](int, int, int) { return true; });
    const std::vector<double> ways = waysFromMiddle(body, noLegs(body));
    const std::vector<double> expected = test::waysByRounds(body.cubes, nearMiddle(body, noLegs(body)));
    CHECK(std::ranges::equal(ways, expected, [](double a, double b) { return std::abs(a - b) < 1e-9; }));
  }
}

TEST_CASE("An arm's line goes from the cell farthest from the middle to the middle, in sections of two cubes",
          "[locators]") {
  const StandingBody body = armed({.right = 20, .left = 26});
  const LegLines legs = noLegs(body);
  const std::vector<double> fromMiddle = waysFromMiddle(body, legs);
  for (const double side : {-1.0, 1.0}) {
    const ArmLine arm = armLine(body, legs, fromMiddle, side, far);
    double way = 0.0;
    std::uint32_t tip = 0;
    for (std::uint32_t cell = 0; cell < fromMiddle.size(); ++cell) {
      if (side * body.middleOf(cell).x > 0.0 && fromMiddle[cell] > way) {
        way = fromMiddle[cell];
        tip = cell;
      }
    }
    CHECK(arm.way == way);
    CHECK(arm.ownPiece == 0.0);
    const std::vector<double> fromTip = test::waysByRounds(body.cubes, {tip});
    std::vector<std::pair<Vec3, double>> places;
    for (std::uint32_t cell = 0; cell < fromTip.size(); ++cell) {
      if (fromTip[cell] < way - 1e-9) {
        places.emplace_back(body.middleOf(cell), fromTip[cell]);
      }
    }
    CHECK(arm.cells.size() == places.size());
    checkSections(arm.sections, heaped(body, places));
  }
}

TEST_CASE("A hand is no lower than six tenths of the crotch, no leg, and no farther than told",
          "[locators]") {
  const StandingBody body = armed({.right = 20, .left = 26});
  LegLines legs = noLegs(body);
  const std::vector<double> fromMiddle = waysFromMiddle(body, legs);
  const double size = body.cubes.grid.size;
  const double whole = armLine(body, legs, fromMiddle, 1.0, far).way;
  const ArmLine cut = armLine(body, legs, fromMiddle, 1.0, whole - 5.5 * size);
  CHECK(cut.way < whole - 5.4 * size);
  CHECK(cut.way > whole - 7.0 * size);
  CHECK(std::ranges::all_of(cut.cells,
                            [&](const auto& one) { return fromMiddle[one.first] <= whole - 5.5 * size; }));
  CHECK(armLine(body, legs, fromMiddle, 1.0, whole).way == whole);
  legs.crotch = 48.0 / 64.0 / 0.6 + 4.1 / 64.0 / 0.6; // all of the arms is lower
  CHECK(armLine(body, legs, fromMiddle, 1.0, far).way < 8.0 * size);
  legs.crotch = 2.0;
  CHECK(armLine(body, legs, fromMiddle, 1.0, far).way == 0.0);
  CHECK(armLine(body, legs, fromMiddle, 1.0, far).sections.empty());
  legs.crotch = 0.0;
  legs.isLeg.assign(body.cubes.cellCount(), true);
  CHECK(armLine(body, legs, fromMiddle, 1.0, far).way == 0.0);
}

TEST_CASE("An arm that hangs on bridges is a piece of its own, up to the first of them", "[locators]") {
  StandingBody body = armed({.right = 24, .left = 24});
  const LegLines legs = noLegs(body);
  const double size = body.cubes.grid.size;
  // The cells of one layer of the left arm, three cubes from the trunk, become what joins it.
  std::vector<std::uint32_t> cells = body.cubes.cubeOf;
  std::stable_partition(cells.begin(), cells.end(), [&](std::uint32_t index) {
    const Vec3 middle = body.cubes.grid.middleOf(body.cubes.grid.placeOfIndex(index));
    return std::abs(middle.x - 8.5 * size) > 0.1 * size;
  });
  body.cubes.cubeOf = cells;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    body.cubes.cellAt[cells[cell]] = static_cast<std::int32_t>(cell);
  }
  body.ownCells = cells.size() - 16;
  body.layers = test::layersByPairs(body.cubes);
  const std::vector<double> fromMiddle = waysFromMiddle(body, legs);
  const ArmLine left = armLine(body, legs, fromMiddle, 1.0, far);
  CHECK(left.ownPiece == Approx(20.0 * size).epsilon(0.01)); // from the tip's cube to the bridge's
  CHECK(armLine(body, legs, fromMiddle, -1.0, far).ownPiece == 0.0);
}

namespace {

/// The direction in which places spread most, by the eigenvectors of how they spread.
Vec3 longestOf(const std::vector<Vec3>& places, const Vec3& centroid) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& place : places) {
    const Eigen::Vector3d from(place.x - centroid.x, place.y - centroid.y, place.z - centroid.z);
    spread += from * from.transpose();
  }
  const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  return {axis.x(), axis.y(), axis.z()};
}

std::vector<ArmSection> straightByEigenvectors(const StandingBody& body, const ArmLine& arm, double way) {
  std::vector<Vec3> places;
  Vec3 centroid(0.0);
  for (const auto& [cell, fromTip] : arm.cells) {
    if (fromTip < way) {
      places.push_back(body.middleOf(cell));
      centroid += body.middleOf(cell);
    }
  }
  centroid /= static_cast<double>(places.size());
  const Vec3 axis = longestOf(places, centroid);
  const double side = glm::dot(arm.sections.front().middle - centroid, axis) < 0.0 ? -1.0 : 1.0;
  double tip = 0.0;
  for (const Vec3& place : places) {
    tip = std::max(tip, side * glm::dot(place - centroid, axis));
  }
  std::vector<std::pair<Vec3, double>> ways;
  ways.reserve(places.size());
  for (const Vec3& place : places) {
    ways.emplace_back(place, tip - side * glm::dot(place - centroid, axis));
  }
  return heaped(body, ways);
}

} // namespace

TEST_CASE("Straight sections lie across the line along which an arm spreads most, from its tip on",
          "[locators]") {
  for (const int thick : {2, 4, 5}) {
    const StandingBody body = armed({.right = 20, .left = 27, .thick = thick});
    const LegLines legs = noLegs(body);
    for (const double side : {-1.0, 1.0}) {
      const ArmLine arm = armLine(body, legs, waysFromMiddle(body, legs), side, far);
      for (const double way : {0.21, 0.29}) {
        checkSections(straightSections(body, arm, way), straightByEigenvectors(body, arm, way));
      }
    }
  }
  // Hands that hang down: the way from the middle to the tip is not that in which the arm spreads.
  const StandingBody hooked = test::bodyOfCubes(
      {44, 60, 4}, 1.0 / 64.0, Vec3(-4.0 / 64.0, 0.0, -2.0 / 64.0), [](int x, int y, int z) {
        return x < 8 || (y >= 48 && y < 52 && x < 40) || (x >= 34 && x < 40 && y >= 43 && y < 52 && z < 2);
      });
  const ArmLine hook = armLine(hooked, noLegs(hooked), waysFromMiddle(hooked, noLegs(hooked)), 1.0, far);
  checkSections(straightSections(hooked, hook, 0.4), straightByEigenvectors(hooked, hook, 0.4));
  const StandingBody body = armed({});
  ArmLine nothing;
  CHECK(straightSections(body, nothing, 1.0).empty());
}

TEST_CASE("An arm that bends too much has no straight sections", "[locators]") {
  const auto bent = [](int down) {
    return test::bodyOfCubes({44, 60, 4}, 1.0 / 64.0, Vec3(-4.0 / 64.0, 0.0, -2.0 / 64.0),
                             [=](int x, int y, int) {
                               return x < 8 || (y >= 48 && y < 52 && x < 44 - down) ||
                                      (x >= 40 - down && x < 44 - down && y < 52 && y >= 48 - down);
                             });
  };
  const auto sectionsOf = [](const StandingBody& body) {
    const LegLines legs = noLegs(body);
    const ArmLine arm = armLine(body, legs, waysFromMiddle(body, legs), 1.0, far);
    return straightSections(body, arm, 0.9 * arm.way);
  };
  CHECK_FALSE(sectionsOf(bent(0)).empty());
  CHECK_FALSE(sectionsOf(bent(2)).empty());
  CHECK(sectionsOf(bent(17)).empty());
}

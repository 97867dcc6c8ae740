// Regions of bones in a body of cubes, and how they flow into each other: against ways and flows that are
// calculated in a slower way.
#include <algorithm>
#include <map>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/bind/weight_blend.h"
#include "tests/support/skinning/cube_bodies.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A row of joints along x, 3 apart, from (0.5, y, z) on, and lines between them, the last one for 3 on.
struct Row {
  std::vector<BindJoint> joints;
  std::vector<BoneLine> lines;
};

Row rowOf(std::size_t joints, const Vec3& first) {
  Row row;
  for (std::size_t j = 0; j < joints; ++j) {
    const Vec3 place = first + Vec3(3.0 * static_cast<double>(j), 0.0, 0.0);
    row.joints.push_back({place, static_cast<int>(j) - 1});
    const bool isLast = j + 1 == joints;
    row.lines.push_back({static_cast<std::uint16_t>(j), place, place + Vec3(3.0, 0.0, 0.0),
                         isLast ? -1 : static_cast<int>(j) + 1});
  }
  return row;
}

VoxelBody sheet(const glm::ivec3& counts, const std::function<bool(int, int, int)>& filled) {
  return test::bodyOfCubes(counts, 1.0, Vec3(0.0), filled).cubes;
}

using Weights = std::map<int, double>;

/// Heat that flows over faces, all of it at once in numbers of double size; nothing is left out.
std::vector<Weights> flowed(const VoxelBody& body, const std::vector<BoneLine>& lines,
                            const SkeletonWays& ways, const std::vector<CellOwner>& owners,
                            const std::vector<double>& radii, double blend) {
  double widest = 0.0;
  for (const CellOwner& owner : owners) {
    widest = std::max(widest, radii[lines[owner.line].joint]);
  }
  const double spread = blend * widest / body.grid.size;
  const int steps = std::clamp(static_cast<int>(std::ceil(3.5 * spread * spread)), 1, 400);
  const double full = std::min(spread * spread / (2.0 * steps), 1.0 / 6.5);
  const auto rateOf = [&](std::size_t cell) {
    const double part = radii[lines[owners[cell].line].joint] / widest;
    return full * part * part;
  };
  const auto isOpen = [&](std::size_t a, std::size_t b) {
    const CellOwner& one = owners[a];
    const CellOwner& other = owners[b];
    const double across = static_cast<double>(one.distance + other.distance) + body.grid.size;
    return lines[one.line].joint == lines[other.line].joint ||
           ways.kinship({one.line, static_cast<double>(one.along)},
                        {other.line, static_cast<double>(other.along)}, across) > 0.5;
  };
  std::vector<Weights> now(owners.size());
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    now[cell][lines[owners[cell].line].joint] = 1.0;
  }
  for (int step = 0; step < steps; ++step) {
    std::vector<Weights> next = now;
    for (std::size_t cell = 0; cell < owners.size(); ++cell) {
      for (std::size_t other = 0; other < owners.size(); ++other) {
        const bool isBeside = glm::distance(body.middleOf(cell), body.middleOf(other)) < 1.1 * body.grid.size;
        if (cell != other && isBeside && isOpen(cell, other)) {
          const double rate = 0.5 * (rateOf(cell) + rateOf(other));
          for (const auto& [joint, weight] : now[other]) {
            next[cell][joint] += rate * weight;
          }
          for (const auto& [joint, weight] : now[cell]) {
            next[cell][joint] -= rate * weight;
          }
        }
      }
    }
    now = std::move(next);
  }
  return now;
}

void checkWeights(const std::vector<CellWeights>& is, const std::vector<Weights>& wanted) {
  REQUIRE(is.size() == wanted.size());
  for (std::size_t cell = 0; cell < is.size(); ++cell) {
    float before = 2.0F;
    double sum = 0.0;
    for (std::size_t i = 0; i < CellWeights::capacity; ++i) {
      CHECK(is[cell].weights[i] <= before);
      before = is[cell].weights[i];
      sum += static_cast<double>(before);
      if (before > 0.0F) {
        CHECK(static_cast<double>(before) == Approx(wanted[cell].at(is[cell].joints[i])).margin(2e-5));
      }
    }
    CHECK(sum == Approx(1.0));
  }
}

std::vector<BoneCell> cellsAlong(const VoxelBody& body, const std::vector<BoneLine>& lines) {
  return boneCells(body, lines);
}

} // namespace

TEST_CASE("Each cell belongs to the bone that is nearest inside the body, thick ones reaching farther") {
  std::mt19937 chance(11);
  for (int round = 0; round < 8; ++round) {
    const VoxelBody body =
        sheet({9, 7, 4}, [&](int x, int y, int) { return chance() % 10 < 7U || (x == 4 && y == 3); });
    std::vector<BoneLine> lines(3);
    for (std::size_t line = 0; line < 3; ++line) {
      lines[line].joint = static_cast<std::uint16_t>(line == 2 ? 0 : line + 1); // two lines of joint 1 or so
    }
    lines[2].joint = 1;
    const std::vector<double> radii{9.0, 0.4, 1.3};
    std::vector<BoneCell> seeds;
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
      seeds.push_back({chance() % body.cellCount(), seed % 3, 0.1F * static_cast<float>(seed),
                       0.07 * static_cast<double>(chance() % 20)});
    }
    for (const double sections : {0.0, 0.8}) {
      const std::vector<CellOwner> owners = boneRegions(body, lines, seeds, radii, sections);
      std::vector<std::vector<double>> ways;
      ways.reserve(seeds.size());
      for (const BoneCell& seed : seeds) {
        ways.push_back(test::waysByRounds(body, {static_cast<std::uint32_t>(seed.cell)}));
      }
      for (std::size_t cell = 0; cell < owners.size(); ++cell) {
        double least = 1e300;
        for (std::size_t s = 0; s < seeds.size(); ++s) {
          least = std::min(least,
                           ways[s][cell] + seeds[s].distance - sections * radii[lines[seeds[s].line].joint]);
        }
        if (least > 1e200) {
          CHECK(owners[cell].line == CellOwner::nobody);
          CHECK(owners[cell].distance == 0.0F);
          continue;
        }
        REQUIRE(owners[cell].line != CellOwner::nobody);
        const double reach = sections * radii[lines[owners[cell].line].joint];
        CHECK(static_cast<double>(owners[cell].distance) - reach == Approx(least).margin(1e-5));
        // The place on the bone is that of the seed from which the cell was reached.
        CHECK(std::ranges::any_of(seeds, [&](const BoneCell& seed) {
          const auto s = static_cast<std::size_t>(&seed - seeds.data());
          return seed.line == owners[cell].line && seed.along == owners[cell].along &&
                 std::abs(ways[s][cell] + seed.distance - reach - least) < 1e-5;
        }));
      }
    }
  }
}

TEST_CASE("Weights flow over the borders of regions as heat does, by the bones' thickness") {
  const Row row = rowOf(4, Vec3(0.0, 1.5, 1.5));
  const VoxelBody body = sheet({12, 3, 3}, [](int x, int y, int z) { return x != 5 || y != 2 || z != 2; });
  const SkeletonWays ways(row.joints, row.lines);
  for (const double blend : {0.3, 1.0, 2.2}) {
    const std::vector<double> radii{1.5, 1.1, 0.6, 1.5};
    const std::vector<CellOwner> owners =
        boneRegions(body, row.lines, cellsAlong(body, row.lines), radii, 0.5);
    checkWeights(blendedRegions(body, row.lines, ways, owners, radii, blend, {}),
                 flowed(body, row.lines, ways, owners, radii, blend));
  }
}

TEST_CASE("Nothing flows between parts that touch and are far from each other along the skeleton") {
  // Two rows side by side that hang together at their far ends only.
  Row row = rowOf(4, Vec3(0.0, 0.5, 0.5));
  const Row other = rowOf(4, Vec3(0.0, 2.5, 0.5));
  for (std::size_t j = 0; j < 4; ++j) {
    row.joints.push_back({other.joints[j].place, j == 0 ? 0 : static_cast<int>(j) + 3});
    row.lines.push_back({static_cast<std::uint16_t>(j + 4), other.lines[j].start, other.lines[j].end,
                         j == 3 ? -1 : static_cast<int>(j) + 5});
  }
  const VoxelBody body = sheet({12, 3, 1}, [](int, int, int) { return true; });
  const SkeletonWays ways(row.joints, row.lines);
  const std::vector<double> radii(8, 1.0);
  const std::vector<CellOwner> owners = boneRegions(body, row.lines, cellsAlong(body, row.lines), radii, 0.0);
  const std::vector<CellWeights> weights = blendedRegions(body, row.lines, ways, owners, radii, 1.5, {});
  checkWeights(weights, flowed(body, row.lines, ways, owners, radii, 1.5));
  const auto at = [&](const Vec3& place) {
    return weights[static_cast<std::size_t>(body.cellNear(place, 0))];
  };
  CHECK(std::ranges::none_of(at(Vec3(11.5, 0.5, 0.5)).joints, [](std::uint16_t joint) { return joint > 3; }));
  CHECK(std::ranges::any_of(at(Vec3(0.5, 0.5, 0.5)).joints, [](std::uint16_t joint) { return joint > 3; }));
}

TEST_CASE("Of many joints that come together in a cell the six strongest stay and make up the whole") {
  Row row;
  constexpr std::size_t arms = 9;
  for (std::size_t j = 0; j < arms; ++j) { // all joints at one place, so that all are kin
    row.joints.push_back({Vec3(0.0), j == 0 ? -1 : 0});
    row.lines.push_back({static_cast<std::uint16_t>(j), Vec3(0.0), Vec3(0.0), -1});
  }
  const VoxelBody body = sheet({3, 3, 1}, [](int, int, int) { return true; });
  std::vector<BoneCell> seeds;
  for (std::uint32_t cell = 0; cell < arms; ++cell) {
    seeds.push_back({cell, cell, 0.0F, 0.0});
  }
  const std::vector<double> radii(arms, 1.0);
  const std::vector<CellOwner> owners = boneRegions(body, row.lines, seeds, radii, 0.0);
  const SkeletonWays ways(row.joints, row.lines);
  const std::vector<CellWeights> weights = blendedRegions(body, row.lines, ways, owners, radii, 3.0, {});
  for (const CellWeights& cell : weights) {
    float sum = 0.0F;
    for (std::size_t i = 0; i < CellWeights::capacity; ++i) {
      CHECK(cell.weights[i] > 0.0F);
      CHECK(std::ranges::count(cell.joints, cell.joints[i]) == 1);
      sum += cell.weights[i];
    }
    CHECK(sum == Approx(1.0F));
    CHECK(std::ranges::is_sorted(cell.weights, std::greater<>{}));
  }
}

TEST_CASE("Blending tells how far it is, step by step, and answers what it has where it is told to stop") {
  const Row row = rowOf(2, Vec3(0.0, 0.5, 0.5));
  const VoxelBody body = sheet({6, 1, 1}, [](int, int, int) { return true; });
  const std::vector<double> radii{1.0, 1.0};
  const std::vector<CellOwner> owners = boneRegions(body, row.lines, cellsAlong(body, row.lines), radii, 0.0);
  const SkeletonWays ways(row.joints, row.lines);
  std::vector<double> told;
  const auto all = blendedRegions(body, row.lines, ways, owners, radii, 2.0, [&](double share) {
    told.push_back(share);
    return true;
  });
  REQUIRE(told.size() == 14); // 3.5 times two squared
  for (std::size_t i = 0; i < told.size(); ++i) {
    CHECK(told[i] == Approx(static_cast<double>(i) / 14.0));
  }
  const auto none = blendedRegions(body, row.lines, ways, owners, radii, 2.0, [](double) { return false; });
  for (std::size_t cell = 0; cell < none.size(); ++cell) {
    CHECK(none[cell].weights[0] == 1.0F);
    CHECK(none[cell].joints[0] == row.lines[owners[cell].line].joint);
  }
  CHECK(all[2].weights[0] < 1.0F);
  const auto few = blendedRegions(body, row.lines, ways, owners, radii, 1e-6, {});
  CHECK(few[2].weights[0] > 0.999F);
}

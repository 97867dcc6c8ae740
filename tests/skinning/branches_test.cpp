#include "skinning/body/branches.h"

#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A strip of vertices half a unit apart, 10 long and 1 thick, as seen from its first one; and from its
/// middle another strip.
struct Strips {
  std::vector<double> distances;
  std::vector<double> diameters;
  std::vector<Triangle> triangles;

  explicit Strips(std::uint32_t sideVertices) {
    constexpr std::uint32_t last = 20;
    for (std::uint32_t v = 0; v <= last; ++v) {
      add(v, v == 0 ? 0 : v - 1);
    }
    for (std::uint32_t i = 0; i < sideVertices; ++i) {
      add(last + 1 + i, i == 0 ? last / 2 : last + i);
    }
  }

private:
  void add(std::uint32_t vertex, std::uint32_t before) {
    distances.push_back(vertex == 0 ? 0.0 : distances[before] + 0.5);
    diameters.push_back(1.0);
    triangles.push_back({before, vertex, vertex});
  }
};

bool hasLimb(const Strips& strips) {
  return hasLimbBeside(strips.distances, strips.diameters, strips.triangles);
}

} // namespace

TEST_CASE("a limb beside the row sticks out by more than it is thick") {
  CHECK_FALSE(hasLimb(Strips(0)));
  CHECK_FALSE(hasLimb(Strips(2))); // as long as it is thick
  CHECK(hasLimb(Strips(3)));
  CHECK(hasLimb(Strips(8)));
}

TEST_CASE("what cannot be reached is no limb") {
  Strips strips(8);
  for (std::size_t v = 21; v < strips.distances.size(); ++v) {
    strips.distances[v] = std::numeric_limits<double>::infinity();
  }
  CHECK_FALSE(hasLimb(strips));
}

namespace {

/// Two strips side by side over the first `slices` twentieths of a body, one over the rest; a vertex in each
/// half of a slice. The second strip has `share` of the area of the first.
bool isBranchedOver(std::uint32_t slices, double share, std::uint32_t first = 0) {
  std::vector<double> along;
  std::vector<double> areas;
  std::vector<Triangle> triangles;
  for (const std::uint32_t strip : {0U, 1U}) {
    const auto start = static_cast<std::uint32_t>(along.size());
    for (std::uint32_t i = 0; i < (strip == 0 ? 40U : 2 * slices); ++i) {
      along.push_back((i + 0.5) / 40.0 + (strip == 0 ? 0.0 : first / 20.0));
      areas.push_back(strip == 0 ? 1.0 : share);
      if (i > 0) {
        triangles.push_back({start + i - 1, start + i, start + i});
      }
    }
  }
  return isBranched(along, areas, triangles);
}

} // namespace

TEST_CASE("a body branches where more than a fifth of its slices fall into pieces") {
  for (const std::uint32_t first : {0U, 7U, 15U}) {
    CHECK_FALSE(isBranchedOver(4, 1.0, first));
    CHECK(isBranchedOver(5, 1.0, first));
  }
  CHECK(isBranchedOver(20, 1.0));
  CHECK_FALSE(isBranchedOver(0, 1.0));
}

TEST_CASE("a piece of a slice counts from a tenth of its area on, be it the first or the second") {
  CHECK(isBranchedOver(5, 0.12));       // 0.107 of both
  CHECK_FALSE(isBranchedOver(5, 0.11)); // 0.099
  CHECK(isBranchedOver(5, 8.0));
  CHECK_FALSE(isBranchedOver(5, 9.5));
}

TEST_CASE("what is beyond the ends of a body counts to its first and last slice") {
  // Five vertices without neighbours in one slice are as many pieces of it.
  CHECK_FALSE(isBranched({-0.3, -0.2, 0.01, 1.0, 1.5}, {1, 1, 1, 1, 1}, {}));
  std::vector<double> along;
  for (int slice = 0; slice < 5; ++slice) {
    along.insert(along.end(), {slice / 20.0 + 0.01, slice / 20.0 + 0.02});
  }
  CHECK(isBranched(along, std::vector<double>(10, 1.0), {}));
  along[0] = -1.0;
  along[9] = 0.999;
  CHECK_FALSE(isBranched(along, std::vector<double>(10, 1.0), {}));
}

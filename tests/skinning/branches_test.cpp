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

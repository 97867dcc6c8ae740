// Slices of drawn surfaces counted piece by piece, and limbs whose triangles begin with any corner.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "skinning/body/branches.h"
#include "tests/support/row.h"

using namespace stretch;

namespace {

struct Sliced {
  std::vector<double> along;
  std::vector<double> areas;
  std::vector<Triangle> triangles;
};

Sliced drawnSurface(test::Row& row) {
  Sliced surface;
  const std::uint32_t count = 20 + row.below(60);
  for (std::uint32_t v = 0; v < count; ++v) {
    surface.along.push_back(row.once(20) ? 1.0 : row.between(0.0, 1.0));
    surface.areas.push_back(row.between(0.1, 1.0));
  }
  for (std::uint32_t i = row.below(8 * count); i > 0; --i) {
    surface.triangles.push_back({row.below(count), row.below(count), row.below(count)});
  }
  return surface;
}

std::size_t sliceAt(double along) {
  return along >= 1.0 ? 19 : static_cast<std::size_t>(along * 20.0);
}

/// Floods each slice over edges within it; a piece of more than a tenth of its slice counts.
bool isBranchedByFlooding(const Sliced& surface) {
  const std::size_t count = surface.along.size();
  int several = 0;
  for (std::size_t slice = 0; slice < 20; ++slice) {
    std::vector<bool> left(count);
    double whole = 0.0;
    for (std::size_t v = 0; v < count; ++v) {
      left[v] = sliceAt(surface.along[v]) == slice;
      whole += left[v] ? surface.areas[v] : 0.0;
    }
    int pieces = 0;
    for (std::size_t first = 0; first < count; ++first) {
      if (!left[first]) {
        continue;
      }
      std::vector<std::size_t> waiting{first};
      left[first] = false;
      double area = 0.0;
      while (!waiting.empty()) {
        const std::size_t v = waiting.back();
        waiting.pop_back();
        area += surface.areas[v];
        for (const Triangle& triangle : surface.triangles) {
          if (std::ranges::find(triangle, static_cast<std::uint32_t>(v)) == triangle.end()) {
            continue;
          }
          for (const std::uint32_t corner : triangle) {
            if (left[corner]) {
              left[corner] = false;
              waiting.push_back(corner);
            }
          }
        }
      }
      pieces += area > 0.1 * whole ? 1 : 0;
    }
    several += pieces > 1 ? 1 : 0;
  }
  return several > 4;
}

} // namespace

TEST_CASE("A drawn surface is branched where more than four of twenty slices fall into several pieces",
          "[drawn-branches]") {
  test::Row row(9);
  std::size_t branched = 0;
  for (int i = 0; i < 400; ++i) {
    const Sliced surface = drawnSurface(row);
    const bool wanted = isBranchedByFlooding(surface);
    CHECK(skinning::isBranched(surface.along, surface.areas, surface.triangles) == wanted);
    branched += wanted ? 1U : 0U;
  }
  CHECK(branched > 40);
  CHECK(branched < 360);
}

TEST_CASE("Two vertices are of one piece by whichever edge of a triangle they are joined",
          "[drawn-branches]") {
  const std::size_t turned = GENERATE(0, 1, 2);
  const auto slices = GENERATE(4, 5, 20);
  // In so many slices two vertices that an edge joins, or none; the third corner lies in another slice.
  for (const bool joined : {true, false}) {
    Sliced surface;
    for (int slice = 0; slice < 20; ++slice) {
      const auto first = static_cast<std::uint32_t>(surface.along.size());
      const double along = (slice + 0.5) / 20.0;
      surface.along.insert(surface.along.end(), slice < slices ? 2 : 1, along);
      if (slice < slices && joined) {
        const std::uint32_t other = slice == 0 ? 2U : 0U;
        Triangle triangle{first, first + 1, other};
        std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(turned), triangle.end());
        surface.triangles.push_back(triangle);
      }
    }
    surface.areas.assign(surface.along.size(), 1.0);
    CHECK(skinning::isBranched(surface.along, surface.areas, surface.triangles) == (!joined && slices > 4));
  }
}

TEST_CASE("A limb is found by whichever edge its vertices are joined, and where it is only its far end",
          "[drawn-branches]") {
  const std::size_t turned = GENERATE(0, 1, 2);
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  // A row of vertices half a unit apart, and from its middle another one; the third corner of each triangle
  // cannot be reached.
  for (const auto& [side, isLimb] : {std::pair(0U, false), {2U, false}, {3U, true}, {9U, true}}) {
    std::vector<double> distances{nowhere, 0.0};
    std::vector<Triangle> triangles;
    const auto add = [&](std::uint32_t before) {
      const auto vertex = static_cast<std::uint32_t>(distances.size());
      distances.push_back(distances[before] + 0.5);
      Triangle triangle{before, vertex, 0U};
      std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(turned), triangle.end());
      triangles.push_back(triangle);
      return vertex;
    };
    std::uint32_t vertex = 1;
    for (int i = 0; i < 20; ++i) {
      vertex = add(vertex);
    }
    vertex = 11;
    for (std::uint32_t i = 0; i < side; ++i) {
      vertex = add(vertex);
    }
    CAPTURE(turned, side);
    CHECK(skinning::hasLimbBeside(distances, std::vector<double>(distances.size(), 1.0), triangles) ==
          isLimb);
  }
}

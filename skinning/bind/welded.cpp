#include "skinning/bind/welded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/disjoint_sets.h"
#include "core/math/types.h"

namespace stretch::skinning {

namespace {

using Place = std::array<std::int64_t, 3>;

// Joins vertices in one cell of a grid.
void joinInCells(std::span<const glm::vec3> positions, double cell, double shift, DisjointSets& sets) {
  std::vector<std::pair<Place, std::uint32_t>> sorted(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 scaled = Vec3(positions[v]) / cell + shift;
    sorted[v] = {{static_cast<std::int64_t>(std::floor(scaled.x)),
                  static_cast<std::int64_t>(std::floor(scaled.y)),
                  static_cast<std::int64_t>(std::floor(scaled.z))},
                 static_cast<std::uint32_t>(v)};
  }
  std::ranges::sort(sorted);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) {
      sets.join(sorted[i - 1].second, sorted[i].second);
    }
  }
}

} // namespace

std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> leaders(positions.size());
  std::iota(leaders.begin(), leaders.end(), std::uint32_t{0});
  constexpr double together = 1e-5; // of the box
  const double cell = together * boxDiagonal(positions);
  if (!(cell > 0.0) || !std::isfinite(cell)) {
    return leaders;
  }
  // Two grids, half a cell apart: what an edge of one parts lies in the middle of a cell of the other.
  DisjointSets sets(positions.size());
  joinInCells(positions, cell, 0.0, sets);
  joinInCells(positions, cell, 0.5, sets);
  for (std::uint32_t v = 0; v < leaders.size(); ++v) {
    leaders[v] = static_cast<std::uint32_t>(sets.leaderOf(v));
  }
  return leaders;
}

} // namespace stretch::skinning

#include "skinning/body/branches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/disjoint_sets.h"

namespace stretch::skinning {
namespace {

/// The vertices that share an edge with each, some twice.
std::vector<std::vector<std::uint32_t>> neighboursOf(std::size_t vertices,
                                                     const std::vector<Triangle>& triangles) {
  std::vector<std::vector<std::uint32_t>> neighbours(vertices);
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      neighbours[t[c]].push_back(t[(c + 1) % 3]);
      neighbours[t[(c + 1) % 3]].push_back(t[c]);
    }
  }
  return neighbours;
}

/// What lies around a tip, so far as it was flooded from there.
struct Limb {
  double tip = 0.0;       ///< The farthest distance in it.
  double diameters = 0.0; ///< Sum over its vertices.
  double vertices = 0.0;

  void add(const Limb& other) {
    tip = std::max(tip, other.tip);
    diameters += other.diameters;
    vertices += other.vertices;
  }
  /// Whether it sticks out of what is left at a distance by more than it is thick.
  [[nodiscard]] bool sticksOut(double from) const { return (tip - from) * vertices > diameters; }
};

} // namespace

bool isBranched(const std::vector<double>& along, const std::vector<double>& areas,
                const std::vector<Triangle>& triangles) {
  constexpr int slices = 20;
  constexpr double fairShare = 0.1;
  const auto sliceOf = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(along[v] * slices), 0, slices - 1));
  };
  DisjointSets pieces(along.size());
  for (const Triangle& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (sliceOf(triangle[c]) == sliceOf(triangle[(c + 1) % 3])) {
        pieces.join(triangle[c], triangle[(c + 1) % 3]);
      }
    }
  }
  std::vector<double> ofPiece(along.size(), 0.0);
  std::vector<double> ofSlice(slices, 0.0);
  for (std::uint32_t v = 0; v < along.size(); ++v) {
    ofPiece[pieces.leaderOf(v)] += areas[v];
    ofSlice[sliceOf(v)] += areas[v];
  }
  std::vector<int> counts(slices, 0);
  for (std::uint32_t v = 0; v < along.size(); ++v) {
    counts[sliceOf(v)] += ofPiece[v] > fairShare * ofSlice[sliceOf(v)] ? 1 : 0;
  }
  const auto several = std::count_if(counts.begin(), counts.end(), [](int count) { return count > 1; });
  return several > slices / 5;
}

bool hasLimbBeside(const std::vector<double>& distances, const std::vector<double>& vertexDiameters,
                   const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < distances.size(); ++v) {
    if (std::isfinite(distances[v])) {
      order.push_back(v);
    }
  }
  std::ranges::stable_sort(order,
                           [&](std::uint32_t a, std::uint32_t b) { return distances[a] > distances[b]; });
  const auto neighbours = neighboursOf(distances.size(), triangles);
  DisjointSets pieces(distances.size());
  std::vector<bool> flooded(distances.size(), false);
  std::vector<Limb> limbs(distances.size());
  for (const std::uint32_t v : order) { // From the farthest down: limbs grow and meet.
    flooded[v] = true;
    limbs[v] = {distances[v], vertexDiameters[v], 1.0};
    for (const std::uint32_t other : neighbours[v]) {
      const std::size_t a = pieces.leaderOf(v);
      const std::size_t b = pieces.leaderOf(other);
      if (!flooded[other] || a == b) {
        continue;
      }
      const Limb& lower = limbs[a].tip < limbs[b].tip ? limbs[a] : limbs[b];
      if (lower.sticksOut(distances[v])) {
        return true;
      }
      pieces.join(a, b);
      limbs[std::min(a, b)].add(limbs[std::max(a, b)]);
    }
  }
  return false;
}

} // namespace stretch::skinning

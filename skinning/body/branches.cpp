#include "skinning/body/branches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace stretch::skinning {
namespace {

/// Pieces of a surface that is cut across, by union and find.
class Pieces {
public:
  explicit Pieces(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }
  [[nodiscard]] std::uint32_t of(std::uint32_t v) {
    while (parents_[v] != v) {
      parents_[v] = parents_[parents_[v]];
      v = parents_[v];
    }
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) { parents_[of(a)] = of(b); }

private:
  std::vector<std::uint32_t> parents_;
};

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
  Pieces pieces(along.size());
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
    ofPiece[pieces.of(v)] += areas[v];
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
  Pieces pieces(distances.size());
  std::vector<bool> flooded(distances.size(), false);
  std::vector<Limb> limbs(distances.size());
  for (const std::uint32_t v : order) { // From the farthest down: limbs grow and meet.
    flooded[v] = true;
    limbs[v] = {distances[v], vertexDiameters[v], 1.0};
    for (const std::uint32_t other : neighbours[v]) {
      const std::uint32_t a = pieces.of(v);
      const std::uint32_t b = pieces.of(other);
      if (!flooded[other] || a == b) {
        continue;
      }
      const Limb& lower = limbs[a].tip < limbs[b].tip ? limbs[a] : limbs[b];
      if (lower.sticksOut(distances[v])) {
        return true;
      }
      pieces.join(a, b);
      limbs[pieces.of(a)].add(limbs[pieces.of(a) == a ? b : a]);
    }
  }
  return false;
}

} // namespace stretch::skinning

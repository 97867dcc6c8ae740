#include "skinning/locate/body_ends.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/disjoint_sets.h"
#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

std::vector<double> waysFromCentre(const StandingBody& body) {
  const std::size_t count = body.cubes.cellCount();
  Vec3 centroid(0.0);
  for (std::size_t cell = 0; cell < count; ++cell) {
    centroid += body.middleOf(cell) / static_cast<double>(count);
  }
  std::size_t centre = 0;
  for (std::size_t cell = 1; cell < count; ++cell) {
    const bool isNearer =
        glm::distance(body.middleOf(cell), centroid) < glm::distance(body.middleOf(centre), centroid);
    centre = isNearer ? cell : centre;
  }
  std::vector<double> ways(count, std::numeric_limits<double>::max());
  ways[centre] = 0.0;
  CellQueue open;
  open.emplace(0.0, static_cast<std::uint32_t>(centre));
  spread(body.cubes, ways, open, [](std::size_t, std::size_t) {});
  return ways;
}

} // namespace

// From the farthest cell inwards each cell begins a heap or joins those that it touches. Where two heaps
// meet, the one that reaches less far out has come to its root.
std::size_t endsOf(const StandingBody& body) {
  constexpr double shortest = 0.2; // of the farthest way
  const std::vector<double> ways = waysFromCentre(body);
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return ways[a] > ways[b]; });
  if (order.empty()) {
    return 0;
  }
  const double least = shortest * ways[order.front()];
  std::vector<std::size_t> places(order.size()); // of cells in the order: the farthest cell leads a heap
  for (std::size_t place = 0; place < order.size(); ++place) {
    places[order[place]] = place;
  }
  DisjointSets heaps(order.size());
  std::size_t ends = 1; // the farthest of all meets no one
  for (std::size_t place = 0; place < order.size(); ++place) {
    eachNeighbour(body.cubes, order[place], [&](std::size_t next, std::size_t) {
      if (places[next] > place) {
        return;
      }
      const std::size_t lesser = std::max(heaps.leaderOf(place), heaps.leaderOf(places[next]));
      if (heaps.join(place, places[next])) {
        ends += ways[order[lesser]] - ways[order[place]] >= least ? 1 : 0;
      }
    });
  }
  return ends;
}

} // namespace stretch::skinning

#include "skinning/locate/body_ends.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/disjoint_sets.h"
#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

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

InwardOrder inwardOrder(const std::vector<double>& ways) {
  InwardOrder order{std::vector<std::size_t>(ways.size()), std::vector<std::size_t>(ways.size())};
  std::iota(order.cells.begin(), order.cells.end(), std::size_t{0});
  std::ranges::stable_sort(order.cells, [&](std::size_t a, std::size_t b) { return ways[a] > ways[b]; });
  for (std::size_t place = 0; place < order.cells.size(); ++place) {
    order.places[order.cells[place]] = place;
  }
  return order;
}

// From the farthest cell inwards each cell begins a heap or joins those that it touches. Where two heaps
// meet, the one that reaches less far out has come to its root.
std::vector<BodyEnd> bodyEnds(const StandingBody& body, const std::vector<double>& ways, double shortest) {
  const InwardOrder inwards = inwardOrder(ways); // the farthest cell leads a heap
  const std::vector<std::size_t>& order = inwards.cells;
  const std::vector<std::size_t>& places = inwards.places;
  if (order.empty()) {
    return {};
  }
  const double least = shortest * ways[order.front()];
  DisjointSets heaps(order.size());
  const auto endAt = [&](std::size_t tip, std::size_t root) {
    return BodyEnd{static_cast<std::uint32_t>(order[tip]), ways[order[tip]] - ways[order[root]],
                   body.middleOf(order[root])};
  };
  std::vector<BodyEnd> ends{endAt(0, order.size() - 1)}; // the farthest of all meets no one
  for (std::size_t place = 0; place < order.size(); ++place) {
    eachNeighbour(body.cubes, order[place], [&](std::size_t next, std::size_t) {
      if (places[next] > place) {
        return;
      }
      const std::size_t lesser = std::max(heaps.leaderOf(place), heaps.leaderOf(places[next]));
      if (heaps.join(place, places[next]) && ways[order[lesser]] - ways[order[place]] >= least) {
        ends.push_back(endAt(lesser, place));
      }
    });
  }
  std::ranges::stable_sort(ends, [](const BodyEnd& a, const BodyEnd& b) { return a.length > b.length; });
  return ends;
}

std::size_t endsOf(const StandingBody& body) {
  constexpr double shortest = 0.2;
  return bodyEnds(body, waysFromCentre(body), shortest).size();
}

} // namespace stretch::skinning

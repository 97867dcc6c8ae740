#include "skinning/locate/body_ends.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

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

// Heaps of cells that touch each other; each is known by its cell that is farthest out.
class Heaps {
public:
  explicit Heaps(std::size_t cells) : above_(cells) {
    std::iota(above_.begin(), above_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t farthestOf(std::size_t cell) {
    while (above_[cell] != cell) {
      above_[cell] = above_[above_[cell]];
      cell = above_[cell];
    }
    return cell;
  }
  void join(std::size_t farthest, std::size_t other) { above_[other] = farthest; }

private:
  std::vector<std::size_t> above_;
};

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
  Heaps heaps(ways.size());
  std::vector<bool> isIn(ways.size(), false);
  std::size_t ends = 1; // the farthest of all meets no one
  for (const std::size_t cell : order) {
    isIn[cell] = true;
    eachNeighbour(body.cubes, cell, [&](std::size_t next, std::size_t) {
      if (!isIn[next]) {
        return;
      }
      std::size_t one = heaps.farthestOf(cell);
      std::size_t other = heaps.farthestOf(next);
      if (one == other) {
        return;
      }
      if (ways[one] < ways[other]) {
        std::swap(one, other);
      }
      ends += ways[other] - ways[cell] >= least ? 1 : 0;
      heaps.join(one, other);
    });
  }
  return ends;
}

} // namespace stretch::skinning

#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "skinning/bind/voxel_body.h"

namespace stretch::skinning {

// Shortest ways from cube to cube inside a body (Dijkstra), over faces, edges and corners of the cubes.

/// Cells that wait, the nearest first.
using CellQueue = std::priority_queue<std::pair<double, std::uint32_t>,
                                      std::vector<std::pair<double, std::uint32_t>>, std::greater<>>;

/// `visit(neighbour, steps)` for each of up to 26 cells beside a cell; its middle is sqrt(steps) cubes away.
template <typename Visit>
void eachNeighbour(const VoxelBody& body, std::size_t cell, Visit&& visit) {
  const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[cell]);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int steps = x * x + y * y + z * z;
        const std::int32_t next = body.cellAt[body.grid.indexOf({place[0] + x, place[1] + y, place[2] + z})];
        if (steps > 0 && next != VoxelBody::outside) {
          visit(static_cast<std::size_t>(next), static_cast<std::size_t>(steps));
        }
      }
    }
  }
}

/// Lowers `distances` to the shortest ways from the cells in `open`; `reached(from, to)` each time a way gets
/// shorter.
template <typename Reached>
void spread(const VoxelBody& body, std::vector<double>& distances, CellQueue& open, Reached&& reached) {
  const double size = body.grid.size;
  const std::array<double, 4> lengths{0.0, size, size * std::sqrt(2.0), size * std::sqrt(3.0)};
  while (!open.empty()) {
    const auto [distance, waiting] = open.top();
    const std::size_t cell = waiting;
    open.pop();
    if (distance > distances[cell]) {
      continue;
    }
    eachNeighbour(body, cell, [&, from = distance](std::size_t next, std::size_t steps) {
      const double way = from + lengths[steps];
      if (way < distances[next]) {
        distances[next] = way;
        reached(cell, next);
        open.emplace(way, static_cast<std::uint32_t>(next));
      }
    });
  }
}

} // namespace stretch::skinning

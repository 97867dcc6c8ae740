#include "tests/support/skinning/cube_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace stretch::test {

namespace {

using namespace skinning;
using Place = std::array<int, 3>;

std::vector<Place> placesOf(const VoxelBody& cubes) {
  std::vector<Place> places;
  for (const std::uint32_t cube : cubes.cubeOf) {
    places.push_back(cubes.grid.placeOfIndex(cube));
  }
  return places;
}

SliceRegion regionOf(const VoxelBody& cubes, std::vector<std::uint32_t> cells) {
  SliceRegion region;
  region.low = Vec3(std::numeric_limits<double>::max());
  region.high = -region.low;
  for (const std::uint32_t cell : cells) {
    const Vec3 middle = cubes.middleOf(cell);
    region.middle += middle;
    region.low = glm::min(region.low, middle);
    region.high = glm::max(region.high, middle);
  }
  region.middle /= static_cast<double>(cells.size());
  region.cells = std::move(cells);
  return region;
}

} // namespace

StandingBody bodyOfCubes(const glm::ivec3& counts, double size, const Vec3& low,
                         const std::function<bool(int, int, int)>& filled) {
  VoxelBody cubes;
  cubes.grid = {low - Vec3(size), size, {counts.x + 2, counts.y + 2, counts.z + 2}};
  cubes.cellAt.assign(cubes.grid.cubeCount(), VoxelBody::outside);
  for (std::size_t cube = 0; cube < cubes.cellAt.size(); ++cube) {
    const auto [x, y, z] = cubes.grid.placeOfIndex(cube);
    const bool isInside = x > 0 && y > 0 && z > 0 && x <= counts.x && y <= counts.y && z <= counts.z;
    if (isInside && filled(x - 1, y - 1, z - 1)) {
      cubes.cellAt[cube] = static_cast<std::int32_t>(cubes.cellCount());
      cubes.cubeOf.push_back(static_cast<std::uint32_t>(cube));
      cubes.depths.push_back(static_cast<float>(size));
    }
  }
  StandingBody body{{}, std::move(cubes), 0, {}};
  body.ownCells = body.cubes.cellCount();
  body.layers = layersByPairs(body.cubes);
  return body;
}

std::vector<std::vector<SliceRegion>> layersByPairs(const VoxelBody& cubes) {
  const std::vector<Place> places = placesOf(cubes);
  std::vector<std::size_t> piece(places.size());
  for (std::size_t cell = 0; cell < places.size(); ++cell) {
    piece[cell] = cell;
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (int step = 0; step < 9; ++step) {
        const Place beside{places[a][0] + step % 3 - 1, places[a][1], places[a][2] + step / 3 - 1};
        const std::int32_t other = cubes.cellAt[cubes.grid.indexOf(beside)];
        if (other != VoxelBody::outside && piece[static_cast<std::size_t>(other)] < piece[a]) {
          piece[a] = piece[static_cast<std::size_t>(other)];
          changes = true;
        }
      }
    }
  }
  std::vector<std::vector<SliceRegion>> layers(static_cast<std::size_t>(cubes.grid.counts[1]));
  std::vector<std::vector<std::uint32_t>> heaps(places.size());
  for (std::uint32_t cell = 0; cell < places.size(); ++cell) {
    heaps[piece[cell]].push_back(cell);
  }
  for (std::vector<std::uint32_t>& heap : heaps) {
    if (!heap.empty()) {
      const auto layer = static_cast<std::size_t>(places[heap.front()][1]);
      layers[layer].push_back(regionOf(cubes, std::move(heap)));
    }
  }
  return layers;
}

std::vector<double> waysByRounds(const VoxelBody& cubes, const std::vector<std::uint32_t>& from) {
  const std::vector<Place> places = placesOf(cubes);
  std::vector<double> ways(places.size(), std::numeric_limits<double>::max());
  for (const std::uint32_t cell : from) {
    ways[cell] = 0.0;
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (int step = 0; step < 27; ++step) {
        const Place side{step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1};
        const std::int32_t other = cubes.cellAt[cubes.grid.indexOf(
            {places[a][0] + side[0], places[a][1] + side[1], places[a][2] + side[2]})];
        if (other == VoxelBody::outside || ways[static_cast<std::size_t>(other)] > 1e300) {
          continue;
        }
        const double length = std::sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
        const double way = ways[static_cast<std::size_t>(other)] + length * cubes.grid.size;
        if (way < ways[a] - 1e-12) {
          ways[a] = way;
          changes = true;
        }
      }
    }
  }
  return ways;
}

} // namespace stretch::test

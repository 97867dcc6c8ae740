#include "skinning/locate/standing_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace stretch::skinning {

namespace {

constexpr int fine = 140; // cubes along the longest side: the gap between an arm and a thigh shows

constexpr std::array<std::array<int, 3>, 6> faces{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

DisjointSets piecesOf(const VoxelBody& body) {
  DisjointSets pieces(body.cellCount());
  for (std::size_t cell = 0; cell < body.cellCount(); ++cell) {
    const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[cell]);
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const std::array<int, 3> beside{place[0] + x, place[1] + y, place[2] + z};
          const std::int32_t other =
              body.grid.contains(beside) ? body.cellAt[body.grid.indexOf(beside)] : VoxelBody::outside;
          if (other != VoxelBody::outside) {
            pieces.join(cell, static_cast<std::size_t>(other));
          }
        }
      }
    }
  }
  return pieces;
}

// Each cube's nearest cell and the cube before it on the way from there.
struct Reach {
  std::vector<std::int32_t> from;
  std::vector<std::uint32_t> before;
  std::vector<std::uint16_t> steps;
};

struct Bridge {
  int steps = 0;
  std::uint32_t a = 0; ///< Cubes beside each other, reached from two pieces.
  std::uint32_t b = 0;
};

Reach reachAround(const VoxelBody& body) {
  Reach reach{std::vector<std::int32_t>(body.cellAt.begin(), body.cellAt.end()),
              std::vector<std::uint32_t>(body.cellAt.size(), 0),
              std::vector<std::uint16_t>(body.cellAt.size(), 0)};
  std::vector<std::uint32_t> open(body.cubeOf);
  for (const std::uint32_t cube : open) {
    reach.before[cube] = cube;
  }
  for (std::size_t next = 0; next < open.size(); ++next) {
    const std::uint32_t cube = open[next];
    const std::array<int, 3> place = body.grid.placeOfIndex(cube);
    for (const auto& step : faces) {
      const std::array<int, 3> beside{place[0] + step[0], place[1] + step[1], place[2] + step[2]};
      if (!body.grid.contains(beside)) {
        continue;
      }
      const auto index = static_cast<std::uint32_t>(body.grid.indexOf(beside));
      if (reach.from[index] == VoxelBody::outside) {
        reach.from[index] = reach.from[cube];
        reach.before[index] = cube;
        reach.steps[index] = static_cast<std::uint16_t>(reach.steps[cube] + 1);
        open.push_back(index);
      }
    }
  }
  return reach;
}

std::vector<Bridge> bridgesOf(const VoxelBody& body, const Reach& reach, DisjointSets& pieces) {
  std::vector<Bridge> bridges;
  for (std::size_t cube = 0; cube < reach.from.size(); ++cube) {
    const std::array<int, 3> place = body.grid.placeOfIndex(cube);
    for (std::size_t side = 0; side < 6; side += 2) {
      const std::array<int, 3> beside{place[0] + faces[side][0], place[1] + faces[side][1],
                                      place[2] + faces[side][2]};
      if (!body.grid.contains(beside)) {
        continue;
      }
      const std::size_t other = body.grid.indexOf(beside);
      const auto a = static_cast<std::size_t>(reach.from[cube]);
      const auto b = static_cast<std::size_t>(reach.from[other]);
      if (a != b && pieces.leaderOf(a) != pieces.leaderOf(b)) {
        bridges.push_back({reach.steps[cube] + reach.steps[other], static_cast<std::uint32_t>(cube),
                           static_cast<std::uint32_t>(other)});
      }
    }
  }
  // Of ways that are about as long the highest: arms and legs hang from what they belong to.
  std::ranges::stable_sort(bridges, [&](const Bridge& a, const Bridge& b) {
    const auto rank = [&](const Bridge& bridge) {
      return std::pair{bridge.steps / 2, -body.grid.placeOfIndex(bridge.a)[1]};
    };
    return rank(a) < rank(b);
  });
  return bridges;
}

void addCell(VoxelBody& body, std::uint32_t cube) {
  if (body.cellAt[cube] == VoxelBody::outside) {
    body.cellAt[cube] = static_cast<std::int32_t>(body.cellCount());
    body.cubeOf.push_back(cube);
    body.depths.push_back(static_cast<float>(0.5 * body.grid.size));
  }
}

void joinPieces(VoxelBody& body) {
  DisjointSets pieces = piecesOf(body);
  const std::size_t count = body.cellCount();
  bool isOne = true;
  for (std::size_t cell = 1; cell < count && isOne; ++cell) {
    isOne = pieces.leaderOf(cell) == pieces.leaderOf(0);
  }
  if (isOne) {
    return;
  }
  const Reach reach = reachAround(body);
  for (const Bridge& bridge : bridgesOf(body, reach, pieces)) {
    if (!pieces.join(static_cast<std::size_t>(reach.from[bridge.a]),
                     static_cast<std::size_t>(reach.from[bridge.b]))) {
      continue;
    }
    for (std::uint32_t cube : {bridge.a, bridge.b}) {
      for (; reach.steps[cube] > 0; cube = reach.before[cube]) {
        addCell(body, cube);
      }
    }
  }
}

SliceRegion regionFrom(const VoxelBody& body, std::uint32_t first, std::vector<bool>& taken) {
  SliceRegion region;
  region.cells.push_back(first);
  taken[first] = true;
  for (std::size_t next = 0; next < region.cells.size(); ++next) {
    const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[region.cells[next]]);
    for (int x = -1; x <= 1; ++x) {
      for (int z = -1; z <= 1; ++z) {
        const std::array<int, 3> beside{place[0] + x, place[1], place[2] + z};
        const std::int32_t other =
            body.grid.contains(beside) ? body.cellAt[body.grid.indexOf(beside)] : VoxelBody::outside;
        if (other != VoxelBody::outside && !taken[static_cast<std::size_t>(other)]) {
          taken[static_cast<std::size_t>(other)] = true;
          region.cells.push_back(static_cast<std::uint32_t>(other));
        }
      }
    }
  }
  region.low = region.high = body.middleOf(first);
  for (const std::uint32_t cell : region.cells) {
    const Vec3 middle = body.middleOf(cell);
    region.middle += middle / static_cast<double>(region.cells.size());
    region.low = glm::min(region.low, middle);
    region.high = glm::max(region.high, middle);
  }
  return region;
}

std::vector<std::vector<SliceRegion>> layersOf(const VoxelBody& body) {
  std::vector<std::vector<SliceRegion>> layers(static_cast<std::size_t>(body.grid.counts[1]));
  std::vector<bool> taken(body.cellCount(), false);
  for (std::uint32_t cell = 0; cell < body.cellCount(); ++cell) {
    if (!taken[cell]) {
      const int layer = body.grid.placeOfIndex(body.cubeOf[cell])[1];
      layers[static_cast<std::size_t>(layer)].push_back(regionFrom(body, cell, taken));
    }
  }
  return layers;
}

// A sheet is one cube thick everywhere.
bool hasVolume(const StandingBody& body) {
  constexpr double cubes = 2.5;
  return std::ranges::any_of(body.cubes.depths, [&](float depth) {
    return static_cast<double>(depth) > cubes * body.cubes.grid.size;
  });
}

Error noBody(const std::string& why) {
  return {why, "", byHand};
}

} // namespace

std::size_t StandingBody::layerAt(double height) const {
  const double layer = (height - cubes.grid.origin.y) / cubes.grid.size;
  return static_cast<std::size_t>(std::clamp(layer, 0.0, static_cast<double>(layers.size()) - 1.0));
}

Result<StandingBody> standingBody(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                                  const Upright& upright) {
  std::vector<glm::vec3> own(positions.size());
  std::ranges::transform(positions, own.begin(),
                         [&](const Vec3& position) { return glm::vec3(upright.toBody(position)); });
  Result<VoxelBody> cubes = voxelBody(own, triangles, fine);
  if (!cubes) {
    return cubes.error();
  }
  StandingBody body{upright, std::move(*cubes), 0, {}};
  body.ownCells = body.cubes.cellCount();
  joinPieces(body.cubes);
  body.layers = layersOf(body.cubes);
  return body;
}

Result<StandingBody> standingIn(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                                UpAxis up, const Proceed& proceed) {
  const auto goesOn = [&](double share) { return !proceed || proceed(share); };
  const Error stopped{"stopped before the locators were found", "", "fit them again"};
  if (triangles.empty()) {
    return noBody("no mesh with triangles is there to fit locators to");
  }
  const Result<Upright> upright = findUpright(positions, triangles, up);
  if (!upright) {
    return noBody(upright.error().what);
  }
  if (!goesOn(0.5)) {
    return stopped;
  }
  Result<StandingBody> body = standingBody(positions, triangles, *upright);
  if (body && !hasVolume(*body)) {
    return noBody("the mesh encloses nothing that a body could be");
  }
  return body && !goesOn(0.8) ? Result<StandingBody>(stopped) : std::move(body);
}

} // namespace stretch::skinning

#include "skinning/bind/voxel_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/bounds.h"
#include "skinning/bind/voxel_lines.h"
#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

constexpr std::array<std::array<int, 3>, 6> faceNeighbours{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

std::array<int, 3> moved(const std::array<int, 3>& place, const std::array<int, 3>& step) {
  return {place[0] + step[0], place[1] + step[1], place[2] + step[2]};
}

using Corners = std::array<Vec3, 3>;

Corners cornersOf(std::span<const glm::vec3> positions, const Triangle& triangle) {
  return {Vec3(positions[triangle[0]]), Vec3(positions[triangle[1]]), Vec3(positions[triangle[2]])};
}

double longestEdge(const Corners& corners) {
  return std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                   glm::distance(corners[2], corners[0])});
}

// Along two edges of a triangle, so that points on it are no farther apart than half a cube.
struct Steps {
  int along = 1;  // from the first corner to the second
  int across = 1; // from both of these to the third

  [[nodiscard]] double points() const { return 0.5 * (along + 2.0) * (across + 1.0); }
};

int stepsFor(double length, double cube) {
  return std::max(1, static_cast<int>(std::ceil(2.0 * length / cube)));
}

Steps evenSteps(const Corners& corners, double cube) {
  const int steps = stepsFor(longestEdge(corners), cube);
  return {steps, steps};
}

// The corners with the longest edge first: few steps lead across a sliver.
Corners fromLongestEdge(Corners corners) {
  const auto edge = [&](std::size_t i) { return glm::distance(corners[i], corners[(i + 1) % 3]); };
  const std::size_t longest = edge(0) >= std::max(edge(1), edge(2)) ? 0 : edge(1) >= edge(2) ? 1 : 2;
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(longest), corners.end());
  return corners;
}

Steps fewestSteps(const Corners& corners, double cube) {
  const double edge = glm::distance(corners[0], corners[1]);
  const double twiceArea = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  return {stepsFor(edge, cube), stepsFor(edge > 0.0 ? twiceArea / edge : 0.0, cube)};
}

void markEvenly(const VoxelGrid& grid, const Corners& corners, Cubes& surface) {
  const int steps = evenSteps(corners, grid.size).along;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps - i; ++j) {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      surface[grid.indexOf(grid.placeOf(corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v))] = 1;
    }
  }
}

void markSparingly(const VoxelGrid& grid, const Corners& corners, Cubes& surface) {
  const Steps steps = fewestSteps(corners, grid.size);
  for (int i = 0; i <= steps.across; ++i) {
    const double u = static_cast<double>(i) / steps.across;
    const int along = static_cast<int>(std::ceil((1.0 - u) * steps.along));
    for (int j = 0; j <= along; ++j) {
      const double v = along > 0 ? (1.0 - u) * j / along : 0.0;
      surface[grid.indexOf(grid.placeOf(corners[0] * (1.0 - u - v) + corners[1] * v + corners[2] * u))] = 1;
    }
  }
}

// How points are spread over a triangle to find the cubes that it passes.
enum class Spread { even, sparing };

// What filling a grid with triangles costs: points on them, and lines that may meet them.
double costOf(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles, double cube,
              Spread spread) {
  constexpr double line = 0.3; // of a point
  double cost = 0.0;
  for (const Triangle& triangle : triangles) {
    const Corners corners = fromLongestEdge(cornersOf(positions, triangle));
    const Vec3 box = (glm::max(glm::max(corners[0], corners[1]), corners[2]) -
                      glm::min(glm::min(corners[0], corners[1]), corners[2])) /
                     cube;
    const Steps steps = spread == Spread::even ? evenSteps(corners, cube) : fewestSteps(corners, cube);
    cost += steps.points() + line * (box.x * box.y + box.y * box.z + box.z * box.x);
  }
  return cost;
}

// Most that a mesh may cost: a sound body passes each cube a few times, however it is made.
double mostCost(const std::vector<Triangle>& triangles) {
  return 6e7 + 60.0 * static_cast<double>(triangles.size());
}

// The cubes that a triangle passes.
void markTriangle(const VoxelGrid& grid, const Corners& corners, Spread spread, Cubes& surface) {
  if (spread == Spread::even) {
    markEvenly(grid, corners, surface);
  } else {
    markSparingly(grid, fromLongestEdge(corners), surface);
  }
}

// What can be reached from the box's border without passing the surface.
Cubes reachedFromOutside(const VoxelGrid& grid, const Cubes& surface) {
  Cubes reached(surface.size(), 0);
  std::vector<std::size_t> open{0}; // the first cube lies in the empty margin
  reached[0] = 1;
  while (!open.empty()) {
    const std::array<int, 3> place = grid.placeOfIndex(open.back());
    open.pop_back();
    for (const auto& step : faceNeighbours) {
      const std::array<int, 3> next = moved(place, step);
      if (!grid.contains(next)) {
        continue;
      }
      const std::size_t index = grid.indexOf(next);
      if (reached[index] == 0 && surface[index] == 0) {
        reached[index] = 1;
        open.push_back(index);
      }
    }
  }
  return reached;
}

VoxelGrid gridAround(const Vec3& low, const Vec3& high, int cubesAlong) {
  const Vec3 extent = high - low;
  VoxelGrid grid;
  grid.size = std::max({extent.x, extent.y, extent.z}) / cubesAlong;
  constexpr int margin = 2; // empty cubes around: the outside is one piece
  grid.origin = low - Vec3(margin * grid.size);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.counts[axis] =
        static_cast<int>(std::ceil(extent[static_cast<glm::length_t>(axis)] / grid.size)) + 2 * margin + 1;
  }
  return grid;
}

// Distances to the outside over the cells, by the shortest way from cube to cube.
std::vector<float> depthsOf(const VoxelBody& body) {
  std::vector<double> depths(body.cellCount(), std::numeric_limits<double>::max());
  CellQueue open;
  for (std::size_t cell = 0; cell < body.cellCount(); ++cell) {
    const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[cell]);
    const bool isBorder = std::any_of(faceNeighbours.begin(), faceNeighbours.end(), [&](const auto& step) {
      return body.cellAt[body.grid.indexOf(moved(place, step))] == VoxelBody::outside;
    });
    if (isBorder) {
      depths[cell] = 0.5 * body.grid.size;
      open.emplace(depths[cell], static_cast<std::uint32_t>(cell));
    }
  }
  spread(body, depths, open, [](std::size_t, std::size_t) {});
  return {depths.begin(), depths.end()};
}

// The cubes of a mesh without their depths; `inner`: how many of them no triangle passes.
struct Filling {
  VoxelBody body;
  std::size_t inner = 0;
};

Filling filling(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                const VoxelGrid& grid, Spread spread) {
  Filling made;
  VoxelBody& body = made.body;
  body.grid = grid;
  Cubes surface(grid.cubeCount(), 0);
  for (const Triangle& triangle : triangles) {
    markTriangle(grid, cornersOf(positions, triangle), spread, surface);
  }
  const Cubes reached = reachedFromOutside(grid, surface);
  const Cubes votes = votesOfLines(grid, positions, triangles);
  body.cellAt.assign(surface.size(), VoxelBody::outside);
  for (std::size_t cube = 0; cube < surface.size(); ++cube) {
    if (surface[cube] != 0 || reached[cube] == 0 || votes[cube] >= 2) {
      body.cellAt[cube] = static_cast<std::int32_t>(body.cubeOf.size());
      body.cubeOf.push_back(static_cast<std::uint32_t>(cube));
      made.inner += surface[cube] == 0 ? 1 : 0;
    }
  }
  return made;
}

// As many cubes along the longest side as a mesh of so few triangles shows anything by: what it encloses is
// measured with large ones.
int cubesThatShow(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                  const Bounds& box, int cubesAlong, Spread spread) {
  constexpr int large = 32;
  const double most = 2e5 + 300.0 * static_cast<double>(triangles.size());
  const double whole = std::pow(cubesAlong, 3.0);
  if (cubesAlong <= large || whole <= most) {
    return cubesAlong;
  }
  const double inner =
      static_cast<double>(filling(positions, triangles, gridAround(box.low, box.high, large), spread).inner);
  const double finest = inner > 0.0 ? large * std::cbrt(most / inner) : cubesAlong;
  return std::clamp(static_cast<int>(finest), large, cubesAlong);
}

} // namespace

std::size_t VoxelGrid::cubeCount() const {
  return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
         static_cast<std::size_t>(counts[2]);
}

bool VoxelGrid::contains(const std::array<int, 3>& place) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (place[axis] < 0 || place[axis] >= counts[axis]) {
      return false;
    }
  }
  return true;
}

std::size_t VoxelGrid::indexOf(const std::array<int, 3>& place) const {
  return (static_cast<std::size_t>(place[0]) * static_cast<std::size_t>(counts[1]) +
          static_cast<std::size_t>(place[1])) *
             static_cast<std::size_t>(counts[2]) +
         static_cast<std::size_t>(place[2]);
}

std::array<int, 3> VoxelGrid::placeOf(const Vec3& point) const {
  std::array<int, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<glm::length_t>(axis);
    const double along = std::floor((point[i] - origin[i]) / size);
    place[axis] = static_cast<int>(std::clamp(along, 0.0, static_cast<double>(counts[axis] - 1)));
  }
  return place;
}

Vec3 VoxelGrid::middleOf(const std::array<int, 3>& place) const {
  return origin + size * (Vec3(place[0], place[1], place[2]) + 0.5);
}

std::array<int, 3> VoxelGrid::placeOfIndex(std::size_t index) const {
  const auto depth = static_cast<std::size_t>(counts[2]);
  const auto height = static_cast<std::size_t>(counts[1]);
  return {static_cast<int>(index / (depth * height)), static_cast<int>(index / depth % height),
          static_cast<int>(index % depth)};
}

std::int32_t VoxelBody::cellNear(const Vec3& point, int cubesAround) const {
  const std::array<int, 3> place = grid.placeOf(point);
  std::int32_t best = cellAt[grid.indexOf(place)];
  if (best != outside) {
    return best;
  }
  double nearest = std::numeric_limits<double>::max();
  for (int x = -cubesAround; x <= cubesAround; ++x) {
    for (int y = -cubesAround; y <= cubesAround; ++y) {
      for (int z = -cubesAround; z <= cubesAround; ++z) {
        const std::array<int, 3> beside = moved(place, {x, y, z});
        const std::int32_t cell = grid.contains(beside) ? cellAt[grid.indexOf(beside)] : outside;
        const double distance = glm::distance(grid.middleOf(beside), point);
        if (cell != outside && distance < nearest) {
          nearest = distance;
          best = cell;
        }
      }
    }
  }
  return best;
}

Result<VoxelBody> voxelBody(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                            int cubesAlong) {
  Vec3 low(std::numeric_limits<double>::max());
  Vec3 high(std::numeric_limits<double>::lowest());
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      low = glm::min(low, Vec3(positions[vertex]));
      high = glm::max(high, Vec3(positions[vertex]));
    }
  }
  const Vec3 extent = high - low;
  const double longest = triangles.empty() ? 0.0 : std::max({extent.x, extent.y, extent.z});
  if (!(longest > 0.0) || !std::isfinite(longest)) {
    return Error{"the mesh has no extent", "", "bind a mesh with a body"};
  }
  constexpr double leastOfDistance = 1e-5; // single precision tells no cubes apart below that
  const Vec3 farthest = glm::max(glm::abs(low), glm::abs(high));
  if (longest < leastOfDistance * std::max({farthest.x, farthest.y, farthest.z})) {
    return Error{"the mesh is too far from the origin for its size", "", "move it to the origin"};
  }
  const double cube = longest / cubesAlong;
  const bool isCheap = costOf(positions, triangles, cube, Spread::even) <= mostCost(triangles);
  const Spread spread = isCheap ? Spread::even : Spread::sparing;
  if (!isCheap && costOf(positions, triangles, cube, spread) > mostCost(triangles)) {
    return Error{"its triangles cross the whole mesh a great many times", "",
                 "export it again: they seem to join the wrong vertices"};
  }
  const int along = cubesThatShow(positions, triangles, {low, high}, cubesAlong, spread);
  VoxelBody body = filling(positions, triangles, gridAround(low, high, along), spread).body;
  body.depths = depthsOf(body);
  return body;
}

} // namespace stretch::skinning

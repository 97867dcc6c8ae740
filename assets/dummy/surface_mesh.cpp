#include "assets/dummy/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stretch::assets {

namespace {

/// Distances at the corners of a grid, and the vertex of each cell.
struct Grid {
  Vec3 low;
  double cell;
  std::array<int, 3> corners; ///< Corners along x, y, z.
  std::vector<double> distances;
  std::vector<int> cellVertices; ///< -1 where the surface does not pass.

  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(corners[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(corners[0]) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] Vec3 corner(int x, int y, int z) const { return low + cell * Vec3(x, y, z); }
};

template <typename Visit>
void forEachCorner(const std::array<int, 3>& counts, Visit visit) {
  for (int z = 0; z < counts[2]; ++z) {
    for (int y = 0; y < counts[1]; ++y) {
      for (int x = 0; x < counts[0]; ++x) {
        visit(x, y, z);
      }
    }
  }
}

Grid sampleGrid(const DistanceField& distance, const Vec3& low, const Vec3& high, double cell) {
  Grid grid{low, cell, {}, {}, {}};
  for (int axis = 0; axis < 3; ++axis) {
    grid.corners[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((high[axis] - low[axis]) / cell)) + 1;
  }
  const auto& counts = grid.corners;
  grid.distances.reserve(grid.index(0, 0, counts[2]));
  forEachCorner(counts,
                [&](int x, int y, int z) { grid.distances.push_back(distance(grid.corner(x, y, z))); });
  grid.cellVertices.assign(grid.distances.size(), -1);
  return grid;
}

/// Mean of the points where the cell's twelve edges cross the surface; `count` is how many do.
struct Crossings {
  Vec3 sum{0.0};
  int count = 0;
};

Crossings cellCrossings(const Grid& grid, int x, int y, int z) {
  Crossings crossings;
  for (int corner = 0; corner < 8; ++corner) {
    const std::array<int, 3> from{corner & 1, (corner >> 1) & 1, (corner >> 2) & 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (from[axis] != 0) {
        continue;
      }
      std::array<int, 3> to = from;
      to[axis] = 1;
      const double a = grid.distances[grid.index(x + from[0], y + from[1], z + from[2])];
      const double b = grid.distances[grid.index(x + to[0], y + to[1], z + to[2])];
      if ((a < 0.0) != (b < 0.0)) {
        const double t = a / (a - b);
        const Vec3 start = grid.corner(x + from[0], y + from[1], z + from[2]);
        crossings.sum += start + t * (grid.corner(x + to[0], y + to[1], z + to[2]) - start);
        ++crossings.count;
      }
    }
  }
  return crossings;
}

void placeVertices(Grid& grid, SurfaceMesh& mesh) {
  const std::array<int, 3> cells{grid.corners[0] - 1, grid.corners[1] - 1, grid.corners[2] - 1};
  forEachCorner(cells, [&](int x, int y, int z) {
    const Crossings crossings = cellCrossings(grid, x, y, z);
    if (crossings.count > 0) {
      grid.cellVertices[grid.index(x, y, z)] = static_cast<int>(mesh.positions.size());
      mesh.positions.push_back(crossings.sum / static_cast<double>(crossings.count));
    }
  });
}

/// The quad of the four cells around a grid edge, as two triangles; `flipped` when the inside lies at the
/// edge's end.
void addQuad(SurfaceMesh& mesh, const std::array<int, 4>& quad, bool flipped) {
  const auto [a, b, c, d] = quad;
  if (flipped) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a, d, c});
  } else {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
}

void joinCells(const Grid& grid, SurfaceMesh& mesh) {
  constexpr std::array<std::array<int, 3>, 3> unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto vertexAt = [&](int x, int y, int z) { return grid.cellVertices[grid.index(x, y, z)]; };
  forEachCorner(grid.corners, [&](int x, int y, int z) {
    const std::array<int, 3> at{x, y, z};
    const bool inside = grid.distances[grid.index(x, y, z)] < 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& u = unit[(axis + 1) % 3];
      const auto& v = unit[(axis + 2) % 3];
      const bool onBorder =
          at[axis] + 1 >= grid.corners[axis] || at[(axis + 1) % 3] == 0 || at[(axis + 2) % 3] == 0;
      if (onBorder ||
          inside ==
              (grid.distances[grid.index(x + unit[axis][0], y + unit[axis][1], z + unit[axis][2])] < 0.0)) {
        continue;
      }
      const std::array<int, 4> quad{vertexAt(x - u[0] - v[0], y - u[1] - v[1], z - u[2] - v[2]),
                                    vertexAt(x - v[0], y - v[1], z - v[2]), vertexAt(x, y, z),
                                    vertexAt(x - u[0], y - u[1], z - u[2])};
      addQuad(mesh, quad, !inside);
    }
  });
}

} // namespace

SurfaceMesh polygonize(const DistanceField& distance, const Vec3& low, const Vec3& high, double cell) {
  Grid grid = sampleGrid(distance, low, high, cell);
  SurfaceMesh mesh;
  placeVertices(grid, mesh);
  joinCells(grid, mesh);
  return mesh;
}

std::vector<std::vector<int>> vertexNeighbours(const SurfaceMesh& mesh) {
  std::vector<std::vector<int>> neighbours(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      auto& list = neighbours[static_cast<std::size_t>(triangle[corner])];
      list.push_back(triangle[(corner + 1) % 3]);
      list.push_back(triangle[(corner + 2) % 3]);
    }
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

} // namespace stretch::assets

#include "skinning/bind/voxel_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace stretch::skinning {

namespace {

constexpr std::array<std::array<int, 3>, 6> faceNeighbours{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

bool isWithin(const VoxelGrid& grid, const std::array<int, 3>& place) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (place[axis] < 0 || place[axis] >= grid.counts[axis]) {
      return false;
    }
  }
  return true;
}

std::array<int, 3> moved(const std::array<int, 3>& place, const std::array<int, 3>& step) {
  return {place[0] + step[0], place[1] + step[1], place[2] + step[2]};
}

using Cubes = std::vector<std::uint8_t>;

// Cubes that a triangle passes, found by points on it that are no farther apart than half a cube.
void markTriangle(const VoxelGrid& grid, const std::array<Vec3, 3>& corners, Cubes& surface) {
  const double longest = std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                                   glm::distance(corners[2], corners[0])});
  const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * longest / grid.size)));
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps - i; ++j) {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      surface[grid.indexOf(grid.placeOf(corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v))] = 1;
    }
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
      if (!isWithin(grid, next)) {
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

// Where lines along one axis meet the triangles, for each line through the middles of cubes.
std::vector<std::vector<float>> crossings(const VoxelGrid& grid, std::span<const glm::vec3> positions,
                                          const std::vector<Triangle>& triangles, std::size_t axis) {
  const std::size_t a = (axis + 1) % 3;
  const std::size_t b = (axis + 2) % 3;
  const auto at = [](const Vec3& v, std::size_t i) { return v[static_cast<glm::length_t>(i)]; };
  std::vector<std::vector<float>> lines(static_cast<std::size_t>(grid.counts[a]) *
                                        static_cast<std::size_t>(grid.counts[b]));
  // Lines a little beside the middles meet no edge of a mesh that is modelled on a grid.
  const double besideA = 0.5 + 1.7e-4;
  const double besideB = 0.5 + 2.3e-4;
  for (const Triangle& triangle : triangles) {
    const std::array<Vec3, 3> p{Vec3(positions[triangle[0]]), Vec3(positions[triangle[1]]),
                                Vec3(positions[triangle[2]])};
    const Vec2 p0(at(p[0], a), at(p[0], b));
    const Vec2 p1(at(p[1], a), at(p[1], b));
    const Vec2 p2(at(p[2], a), at(p[2], b));
    const double area = (p1.x - p0.x) * (p2.y - p0.y) - (p1.y - p0.y) * (p2.x - p0.x);
    if (area == 0.0) {
      continue;
    }
    const auto first = [&](double low, std::size_t i, double beside) {
      return std::max(0, static_cast<int>(std::ceil((low - at(grid.origin, i)) / grid.size - beside)));
    };
    const auto last = [&](double high, std::size_t i, double beside) {
      return std::min(grid.counts[i] - 1,
                      static_cast<int>(std::floor((high - at(grid.origin, i)) / grid.size - beside)));
    };
    for (int i = first(std::min({p0.x, p1.x, p2.x}), a, besideA);
         i <= last(std::max({p0.x, p1.x, p2.x}), a, besideA); ++i) {
      for (int j = first(std::min({p0.y, p1.y, p2.y}), b, besideB);
           j <= last(std::max({p0.y, p1.y, p2.y}), b, besideB); ++j) {
        const Vec2 q(at(grid.origin, a) + (i + besideA) * grid.size, at(grid.origin, b) + (j + besideB) * grid.size);
        const double u = ((q.x - p0.x) * (p2.y - p0.y) - (q.y - p0.y) * (p2.x - p0.x)) / area;
        const double v = ((p1.x - p0.x) * (q.y - p0.y) - (p1.y - p0.y) * (q.x - p0.x)) / area;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0) {
          const double depth = at(p[0], axis) * (1.0 - u - v) + at(p[1], axis) * u + at(p[2], axis) * v;
          lines[static_cast<std::size_t>(i) * static_cast<std::size_t>(grid.counts[b]) + static_cast<std::size_t>(j)]
              .push_back(static_cast<float>(depth));
        }
      }
    }
  }
  return lines;
}

// A vote for each cube that a line along the axis enters and has not left yet.
void vote(const VoxelGrid& grid, std::vector<std::vector<float>>& lines, std::size_t axis, Cubes& votes) {
  const std::size_t a = (axis + 1) % 3;
  const std::size_t b = (axis + 2) % 3;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::vector<float>& depths = lines[line];
    if (depths.empty() || depths.size() % 2 != 0) {
      continue; // a hole: what is inside cannot be said
    }
    std::sort(depths.begin(), depths.end());
    std::array<int, 3> place{};
    place[a] = static_cast<int>(line / static_cast<std::size_t>(grid.counts[b]));
    place[b] = static_cast<int>(line % static_cast<std::size_t>(grid.counts[b]));
    std::size_t passed = 0;
    for (int k = 0; k < grid.counts[axis]; ++k) {
      const double middle = grid.origin[static_cast<glm::length_t>(axis)] + (k + 0.5) * grid.size;
      while (passed < depths.size() && static_cast<double>(depths[passed]) < middle) {
        ++passed;
      }
      if (passed % 2 == 1) {
        place[axis] = k;
        ++votes[grid.indexOf(place)];
      }
    }
  }
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
  std::vector<float> depths(body.cellCount(), std::numeric_limits<float>::max());
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto half = static_cast<float>(0.5 * body.grid.size);
  for (std::size_t cell = 0; cell < body.cellCount(); ++cell) {
    const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[cell]);
    const bool isBorder = std::any_of(faceNeighbours.begin(), faceNeighbours.end(), [&](const auto& step) {
      return body.cellAt[body.grid.indexOf(moved(place, step))] == VoxelBody::outside;
    });
    if (isBorder) {
      depths[cell] = half;
      open.emplace(half, static_cast<std::uint32_t>(cell));
    }
  }
  while (!open.empty()) {
    const auto [depth, cell] = open.top();
    open.pop();
    if (depth > depths[cell]) {
      continue;
    }
    const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[cell]);
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const std::int32_t next = body.cellAt[body.grid.indexOf(moved(place, {x, y, z}))];
          const float reached =
              depth + static_cast<float>(body.grid.size * std::sqrt(static_cast<double>(x * x + y * y + z * z)));
          if (next >= 0 && reached < depths[static_cast<std::size_t>(next)]) {
            depths[static_cast<std::size_t>(next)] = reached;
            open.emplace(reached, static_cast<std::uint32_t>(next));
          }
        }
      }
    }
  }
  return depths;
}

} // namespace

std::size_t VoxelGrid::cubeCount() const {
  return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
         static_cast<std::size_t>(counts[2]);
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
        const std::int32_t cell = isWithin(grid, beside) ? cellAt[grid.indexOf(beside)] : outside;
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
  VoxelBody body;
  body.grid = gridAround(low, high, cubesAlong);
  Cubes surface(body.grid.cubeCount(), 0);
  for (const Triangle& triangle : triangles) {
    markTriangle(body.grid, {Vec3(positions[triangle[0]]), Vec3(positions[triangle[1]]), Vec3(positions[triangle[2]])},
                 surface);
  }
  const Cubes reached = reachedFromOutside(body.grid, surface);
  Cubes votes(surface.size(), 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::vector<float>> lines = crossings(body.grid, positions, triangles, axis);
    vote(body.grid, lines, axis, votes);
  }
  body.cellAt.assign(surface.size(), VoxelBody::outside);
  for (std::size_t cube = 0; cube < surface.size(); ++cube) {
    if (surface[cube] != 0 || reached[cube] == 0 || votes[cube] >= 2) {
      body.cellAt[cube] = static_cast<std::int32_t>(body.cubeOf.size());
      body.cubeOf.push_back(static_cast<std::uint32_t>(cube));
    }
  }
  body.depths = depthsOf(body);
  return body;
}

} // namespace stretch::skinning

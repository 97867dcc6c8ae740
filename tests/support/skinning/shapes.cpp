#include "tests/support/skinning/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace stretch::test {
namespace {

/// Of a vertex in rows of `width` vertices.
std::uint32_t onGrid(int row, int width, int column) {
  return static_cast<std::uint32_t>(row * width + column);
}

std::uint32_t index(std::size_t i) {
  return static_cast<std::uint32_t>(i);
}

std::uint32_t middle(Shape& shape, std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& known,
                     std::uint32_t a, std::uint32_t b) {
  const auto key = std::minmax(a, b);
  const auto found = known.find(key);
  if (found != known.end()) {
    return found->second;
  }
  shape.positions.emplace_back(glm::normalize(Vec3(shape.positions[a]) + Vec3(shape.positions[b])));
  return known[key] = index(shape.positions.size() - 1);
}

/// Two triangles for each cell of a grid of vertices; `at` gives the vertex of a row and a column.
template <typename At>
void addGrid(Shape& shape, int rows, int columns, At&& at) {
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      shape.triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      shape.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  }
}

} // namespace

Shape sphere(int levels) {
  const float t = 1.61803399F;
  Shape shape;
  for (const glm::vec3& p :
       {glm::vec3(-1, t, 0), glm::vec3(1, t, 0), glm::vec3(-1, -t, 0), glm::vec3(1, -t, 0),
        glm::vec3(0, -1, t), glm::vec3(0, 1, t), glm::vec3(0, -1, -t), glm::vec3(0, 1, -t),
        glm::vec3(t, 0, -1), glm::vec3(t, 0, 1), glm::vec3(-t, 0, -1), glm::vec3(-t, 0, 1)}) {
    shape.positions.push_back(glm::normalize(p));
  }
  shape.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    std::vector<Triangle> finer;
    for (const Triangle& tri : shape.triangles) {
      const std::uint32_t ab = middle(shape, known, tri[0], tri[1]);
      const std::uint32_t bc = middle(shape, known, tri[1], tri[2]);
      const std::uint32_t ca = middle(shape, known, tri[2], tri[0]);
      finer.insert(finer.end(), {{tri[0], ab, ca}, {tri[1], bc, ab}, {tri[2], ca, bc}, {ab, bc, ca}});
    }
    shape.triangles = std::move(finer);
  }
  return shape;
}

Shape plane(int cells, double jitter) {
  Shape shape;
  for (int r = 0; r <= cells; ++r) {
    for (int c = 0; c <= cells; ++c) {
      const bool inner = r > 0 && c > 0 && r < cells && c < cells;
      const double dx = inner ? jitter * std::sin(12.9898 * r + 78.233 * c) : 0.0;
      const double dz = inner ? jitter * std::sin(39.3467 * r + 11.135 * c + 1.0) : 0.0;
      shape.positions.emplace_back(Vec3((c + dx) / cells, 0.0, (r + dz) / cells));
    }
  }
  addGrid(shape, cells, cells, [&](int r, int c) { return onGrid(r, cells + 1, c); });
  return shape;
}

Shape torus(double majorRadius, double minorRadius, int around, int across) {
  Shape shape;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * pi * i / around;
      const double v = 2.0 * pi * j / across;
      const double r = majorRadius + minorRadius * std::cos(v);
      shape.positions.emplace_back(Vec3(r * std::cos(u), minorRadius * std::sin(v), r * std::sin(u)));
    }
  }
  addGrid(shape, around, across, [&](int i, int j) { return onGrid(i % around, across, j % across); });
  for (Triangle& triangle : shape.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return shape;
}

Shape tube(double length, double radius, int rings, int sides) {
  Shape shape;
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      const double angle = 2.0 * pi * (s + 0.5 * (r % 2)) / sides;
      shape.positions.emplace_back(
          Vec3(length * r / rings, radius * std::cos(angle), radius * std::sin(angle)));
    }
  }
  addGrid(shape, rings, sides, [&](int r, int s) { return onGrid(r, sides, s % sides); });
  const std::uint32_t first = index(shape.positions.size());
  shape.positions.emplace_back(0.0F, 0.0F, 0.0F);
  shape.positions.emplace_back(Vec3(length, 0.0, 0.0));
  for (int s = 0; s < sides; ++s) {
    const std::uint32_t last = onGrid(rings, sides, 0);
    const auto here = index(static_cast<std::size_t>(s));
    const auto next = index(static_cast<std::size_t>((s + 1) % sides));
    shape.triangles.push_back({first, here, next});
    shape.triangles.push_back({first + 1, last + next, last + here});
  }
  for (Triangle& triangle : shape.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return shape;
}

Shape cubes(const glm::ivec3& low, const glm::ivec3& high, double size,
            const std::function<bool(int, int, int)>& filled) {
  Shape shape;
  std::map<std::array<int, 3>, std::uint32_t> corners;
  const auto isFilled = [&](const glm::ivec3& cell) { return filled(cell.x, cell.y, cell.z); };
  const auto corner = [&](const glm::ivec3& at) {
    const auto [found, isNew] = corners.try_emplace({at.x, at.y, at.z}, index(shape.positions.size()));
    if (isNew) {
      shape.positions.emplace_back(Vec3(at) * size);
    }
    return found->second;
  };
  const auto addSide = [&](const glm::ivec3& cell, int axis, bool front) {
    glm::ivec3 u(0);
    glm::ivec3 v(0);
    glm::ivec3 start = cell;
    start[axis] += front ? 1 : 0;
    u[(axis + 1) % 3] = 1;
    v[(axis + 2) % 3] = 1;
    const std::array<std::uint32_t, 4> side{corner(start), corner(start + u), corner(start + u + v),
                                            corner(start + v)};
    shape.triangles.push_back({side[0], side[front ? 1 : 2], side[front ? 2 : 1]});
    shape.triangles.push_back({side[0], side[front ? 2 : 3], side[front ? 3 : 2]});
  };
  for (glm::ivec3 cell = low; cell.x < high.x; ++cell.x) {
    for (cell.y = low.y; cell.y < high.y; ++cell.y) {
      for (cell.z = low.z; cell.z < high.z; ++cell.z) {
        for (int axis = 0; axis < 3 && isFilled(cell); ++axis) {
          glm::ivec3 step(0);
          step[axis] = 1;
          if (!isFilled(cell + step)) {
            addSide(cell, axis, true);
          }
          if (!isFilled(cell - step)) {
            addSide(cell, axis, false);
          }
        }
      }
    }
  }
  return shape;
}

Shape box(const glm::ivec3& counts, double size) {
  return cubes(glm::ivec3(0), counts, size, [&](int x, int y, int z) {
    return x >= 0 && x < counts.x && y >= 0 && y < counts.y && z >= 0 && z < counts.z;
  });
}

MeshSequence still(const Shape& shape) {
  MeshSequence sequence;
  sequence.name = "still";
  sequence.vertexCount = shape.positions.size();
  sequence.triangles = shape.triangles;
  sequence.positions = shape.positions;
  sequence.frameNames = {"frame 0"};
  return sequence;
}

} // namespace stretch::test

#include "skinning/bind/voxel_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "skinning/bind/seen_triangle.h"

namespace stretch::skinning {

namespace {

using Lines = std::vector<std::vector<float>>;

std::size_t lineOf(const VoxelGrid& grid, std::size_t b, int i, int j) {
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(grid.counts[b]) + static_cast<std::size_t>(j);
}

// Cubes, along one axis, whose lines lie between two places.
std::array<int, 2> between(const VoxelGrid& grid, glm::length_t axis, double low, double high,
                           double beside) {
  const auto count = grid.counts[static_cast<std::size_t>(axis)];
  const double first = std::ceil((low - grid.origin[axis]) / grid.size - beside);
  const double last = std::floor((high - grid.origin[axis]) / grid.size - beside);
  return {std::max(0, static_cast<int>(first)), std::min(count - 1, static_cast<int>(last))};
}

// Where lines along one axis meet the triangles. They run a little beside the middles of the cubes, where
// they meet no edge of a mesh that is modelled on a grid.
Lines crossings(const VoxelGrid& grid, std::span<const glm::vec3> positions,
                const std::vector<Triangle>& triangles, glm::length_t axis) {
  const glm::length_t a = (axis + 1) % 3;
  const glm::length_t b = (axis + 2) % 3;
  constexpr double besideA = 0.5 + 1.7e-4;
  constexpr double besideB = 0.5 + 2.3e-4;
  Lines lines(static_cast<std::size_t>(grid.counts[static_cast<std::size_t>(a)]) *
              static_cast<std::size_t>(grid.counts[static_cast<std::size_t>(b)]));
  for (const Triangle& triangle : triangles) {
    const SeenTriangle seen(positions, triangle, axis);
    const auto [firstA, lastA] = between(grid, a, seen.low(a), seen.high(a), besideA);
    const auto [firstB, lastB] = between(grid, b, seen.low(b), seen.high(b), besideB);
    Vec3 point(0.0);
    for (int i = firstA; i <= lastA; ++i) {
      point[a] = grid.origin[a] + (i + besideA) * grid.size;
      for (int j = firstB; j <= lastB; ++j) {
        point[b] = grid.origin[b] + (j + besideB) * grid.size;
        if (const std::optional<double> met = seen.meets(point)) {
          lines[lineOf(grid, static_cast<std::size_t>(b), i, j)].push_back(static_cast<float>(*met));
        }
      }
    }
  }
  return lines;
}

// A vote for each cube that one line has entered and not left.
void vote(const VoxelGrid& grid, const std::vector<float>& crossed, glm::length_t axis,
          std::array<int, 3> place, Cubes& votes) {
  const auto along = static_cast<std::size_t>(axis);
  std::size_t passed = 0;
  for (place[along] = 0; place[along] < grid.counts[along]; ++place[along]) {
    const double middle = grid.origin[axis] + (place[along] + 0.5) * grid.size;
    while (passed < crossed.size() && static_cast<double>(crossed[passed]) < middle) {
      ++passed;
    }
    if (passed % 2 == 1) {
      ++votes[grid.indexOf(place)];
    }
  }
}

} // namespace

Cubes votesOfLines(const VoxelGrid& grid, std::span<const glm::vec3> positions,
                   const std::vector<Triangle>& triangles) {
  Cubes votes(grid.cubeCount(), 0);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>((axis + 1) % 3);
    const auto b = static_cast<std::size_t>((axis + 2) % 3);
    Lines lines = crossings(grid, positions, triangles, axis);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      if (lines[line].empty() || lines[line].size() % 2 != 0) {
        continue; // a hole: what is inside cannot be said
      }
      std::sort(lines[line].begin(), lines[line].end());
      const auto width = static_cast<std::size_t>(grid.counts[b]);
      std::array<int, 3> place{};
      place[a] = static_cast<int>(line / width);
      place[b] = static_cast<int>(line % width);
      vote(grid, lines[line], axis, place, votes);
    }
  }
  return votes;
}

} // namespace stretch::skinning

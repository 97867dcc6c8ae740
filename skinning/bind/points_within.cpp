#include "skinning/bind/points_within.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "skinning/bind/seen_triangle.h"

namespace stretch::skinning {

namespace {

// How often a line through a point met a shell, and how often beyond the point.
struct Met {
  std::size_t all = 0;
  std::size_t beyond = 0;
};

using MetByShell = std::map<std::size_t, Met>;

// Lines along one axis through all points against all triangles: for each triangle only the points beside it.
std::vector<MetByShell> metAlong(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                                 const std::vector<std::size_t>& shells, const std::vector<Vec3>& points,
                                 glm::length_t axis) {
  const glm::length_t across = (axis + 1) % 3;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto placeOf = [&](std::size_t point) { return points[point][across]; };
  std::ranges::sort(order, {}, placeOf);
  std::vector<MetByShell> met(points.size());
  for (const Triangle& triangle : triangles) {
    const SeenTriangle seen(positions, triangle, axis);
    const double high = seen.high(across);
    for (auto next = std::ranges::lower_bound(order, seen.low(across), {}, placeOf);
         next != order.end() && placeOf(*next) <= high; ++next) {
      if (const std::optional<double> place = seen.meets(points[*next])) {
        Met& shell = met[*next][shells[triangle[0]]];
        ++shell.all;
        shell.beyond += *place > points[*next][axis] ? 1U : 0U;
      }
    }
  }
  return met;
}

} // namespace

std::vector<std::vector<std::size_t>> shellsAround(std::span<const glm::vec3> positions,
                                                   const std::vector<Triangle>& triangles,
                                                   const std::vector<std::size_t>& shells,
                                                   const std::vector<Vec3>& points) {
  std::vector<std::map<std::size_t, int>> votes(points.size());
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const std::vector<MetByShell> met = metAlong(positions, triangles, shells, points, axis);
    for (std::size_t point = 0; point < points.size(); ++point) {
      for (const auto& [shell, count] : met[point]) {
        votes[point][shell] += count.all % 2 == 0 && count.beyond % 2 == 1 ? 1 : 0;
      }
    }
  }
  std::vector<std::vector<std::size_t>> around(points.size());
  for (std::size_t point = 0; point < points.size(); ++point) {
    for (const auto& [shell, count] : votes[point]) {
      if (count >= 2) {
        around[point].push_back(shell);
      }
    }
  }
  return around;
}

} // namespace stretch::skinning

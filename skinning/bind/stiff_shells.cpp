#include "skinning/bind/stiff_shells.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "skinning/bind/voxel_lines.h"

namespace stretch::skinning {

namespace {

using Row = std::vector<double>;

struct ShellBox {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  void take(const glm::vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  [[nodiscard]] double longest() const {
    const glm::vec3 extent = high - low;
    return static_cast<double>(std::max({extent.x, extent.y, extent.z}));
  }
  [[nodiscard]] bool holds(const Vec3& point) const {
    return glm::all(glm::greaterThanEqual(point, Vec3(low))) &&
           glm::all(glm::lessThanEqual(point, Vec3(high)));
  }
};

struct Shell {
  std::vector<std::size_t> vertices;
  std::vector<Triangle> triangles;
  ShellBox box;
};

std::vector<Shell> collect(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  const std::vector<std::size_t> numbers = shellsOf(positions, triangles);
  std::vector<Shell> shells(numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    shells[numbers[v]].vertices.push_back(v);
    shells[numbers[v]].box.take(positions[v]);
  }
  for (const Triangle& triangle : triangles) {
    shells[numbers[triangle[0]]].triangles.push_back(triangle);
  }
  return shells;
}

// Joints whose bones run in the shell: with a part of their length, or for a part of the shell's.
std::vector<std::uint16_t> runningIn(std::span<const glm::vec3> positions, const Shell& shell,
                                     const std::vector<BoneLine>& lines, std::size_t joints) {
  constexpr int samples = 12;
  constexpr double partOfBone = 0.2;
  constexpr double partOfShell = 0.1;
  Row inside(joints, 0.0);
  Row whole(joints, 0.0);
  for (const BoneLine& line : lines) {
    const double length = glm::distance(line.start, line.end) / samples;
    for (int i = 0; i < samples; ++i) {
      const Vec3 point = glm::mix(line.start, line.end, (i + 0.5) / samples);
      whole[line.joint] += length;
      if (shell.box.holds(point) && liesWithin(positions, shell.triangles, point)) {
        inside[line.joint] += length;
      }
    }
  }
  std::vector<std::uint16_t> running;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    if (inside[joint] > std::min(partOfBone * whole[joint], partOfShell * shell.box.longest())) {
      running.push_back(static_cast<std::uint16_t>(joint));
    }
  }
  return running;
}

// The one row that all of the shell follows; none: it bends.
std::optional<Row> asOnePiece(const Shell& shell, const std::vector<std::uint16_t>& running,
                              double bodyLength, const std::vector<Row>& weights) {
  Row mean(weights.front().size(), 0.0);
  for (const std::size_t v : shell.vertices) {
    std::transform(mean.begin(), mean.end(), weights[v].begin(), mean.begin(), std::plus<>());
  }
  const double total = std::accumulate(mean.begin(), mean.end(), 0.0);
  std::transform(mean.begin(), mean.end(), mean.begin(), [&](double weight) { return weight / total; });
  Row alone(mean.size(), 0.0);
  constexpr double agreeing = 0.4; // of the shell follows the bone that runs in it
  if (running.size() == 1 && mean[running.front()] > agreeing) {
    alone[running.front()] = 1.0;
    return alone;
  }
  if (!running.empty()) {
    return std::nullopt;
  }
  constexpr double small = 0.2; // of the body
  if (shell.box.longest() < small * bodyLength) {
    return mean;
  }
  constexpr double ruling = 0.6;
  const auto best = static_cast<std::size_t>(std::max_element(mean.begin(), mean.end()) - mean.begin());
  alone[best] = 1.0;
  return mean[best] > ruling ? std::optional<Row>(alone) : std::nullopt;
}

} // namespace

std::vector<std::size_t> shellsOf(std::span<const glm::vec3> positions,
                                  const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> leaders(positions.size());
  std::iota(leaders.begin(), leaders.end(), std::size_t{0});
  const auto leaderOf = [&](std::size_t v) {
    while (leaders[v] != v) {
      leaders[v] = leaders[leaders[v]];
      v = leaders[v];
    }
    return v;
  };
  std::map<std::array<float, 3>, std::size_t> places;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto [first, isNew] = places.try_emplace({positions[v].x, positions[v].y, positions[v].z}, v);
    leaders[leaderOf(v)] = leaderOf(first->second);
  }
  for (const Triangle& triangle : triangles) {
    leaders[leaderOf(triangle[0])] = leaderOf(triangle[1]);
    leaders[leaderOf(triangle[1])] = leaderOf(triangle[2]);
  }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> shells(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    shells[v] = numbers.try_emplace(leaderOf(v), numbers.size()).first->second;
  }
  return shells;
}

void stiffenShells(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                   const std::vector<BoneLine>& lines, std::vector<std::vector<double>>& weights) {
  const std::vector<Shell> shells = collect(positions, triangles);
  if (shells.size() < 2) {
    return;
  }
  ShellBox body;
  for (const glm::vec3& position : positions) {
    body.take(position);
  }
  for (const Shell& shell : shells) {
    const std::vector<std::uint16_t> running = runningIn(positions, shell, lines, weights.front().size());
    if (const std::optional<Row> row = asOnePiece(shell, running, body.longest(), weights)) {
      for (const std::size_t v : shell.vertices) {
        weights[v] = *row;
      }
    }
  }
}

} // namespace stretch::skinning

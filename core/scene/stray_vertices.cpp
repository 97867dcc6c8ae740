#include "core/scene/stray_vertices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"

namespace stretch {

namespace {

std::size_t verticesOf(const Mesh& mesh) {
  return std::accumulate(mesh.primitives.begin(), mesh.primitives.end(), std::size_t(0),
                         [](std::size_t sum, const Primitive& one) { return sum + one.positions.size(); });
}

// Calls `look` with every vertex's place, one after the other: a mesh may have millions.
template <typename Look>
void forEachPlace(const Mesh& mesh, const Look& look) {
  for (const Primitive& primitive : mesh.primitives) {
    for (const glm::vec3& place : primitive.positions) {
      look(Vec3(place));
    }
  }
}

// Where all but a hundredth at either end of the places are along each axis, told from two thousand of them.
Bounds bulkOf(const Mesh& mesh) {
  constexpr std::size_t most = 2000;
  const std::size_t step = 1 + verticesOf(mesh) / most;
  std::array<std::vector<double>, 3> along;
  std::size_t next = 0;
  forEachPlace(mesh, [&](const Vec3& place) {
    for (int axis = 0; next % step == 0 && axis < 3; ++axis) {
      along[static_cast<std::size_t>(axis)].push_back(place[axis]);
    }
    ++next;
  });
  Bounds bulk;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& places = along[static_cast<std::size_t>(axis)];
    std::ranges::sort(places);
    const std::size_t left = 1 + places.size() / 100; // out at either end
    bulk.low[axis] = places[left];
    bulk.high[axis] = places[places.size() - 1 - left];
  }
  return bulk;
}

} // namespace

std::vector<std::string> strayVertexWarnings(const Scene& scene) {
  constexpr std::size_t fewest = 100;
  constexpr double farOut = 10.0;
  std::vector<std::string> warnings;
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    const std::size_t all = verticesOf(scene.meshes[mesh]);
    if (all < fewest) {
      continue;
    }
    const Bounds bulk = bulkOf(scene.meshes[mesh]);
    std::size_t strays = 0;
    double most = farOut * bulk.largestExtent();
    Vec3 farthest(0.0);
    forEachPlace(scene.meshes[mesh], [&](const Vec3& place) {
      const double away = glm::distance(place, glm::clamp(place, bulk.low, bulk.high));
      strays += away > farOut * bulk.largestExtent() ? 1 : 0;
      farthest = away > most ? place : farthest;
      most = std::max(most, away);
    });
    if (strays > 0 && 100 * strays <= all) {
      warnings.push_back(fmt::format("meshes[{}]: {} of {} vertices stand more than ten times as far out as "
                                     "the others, one at ({:.3g}, {:.3g}, {:.3g}): "
                                     "the size of the character is measured with them; take them away",
                                     mesh, strays, all, farthest.x, farthest.y, farthest.z));
    }
  }
  return warnings;
}

} // namespace stretch

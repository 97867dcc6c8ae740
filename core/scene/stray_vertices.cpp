#include "core/scene/stray_vertices.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"

namespace stretch {

namespace {

// Where all but a hundredth at either end of the places are along each axis, told from two thousand of them.
Bounds bulkOf(const std::vector<Vec3>& places) {
  constexpr std::size_t most = 2000;
  const std::size_t step = 1 + places.size() / most;
  Bounds bulk;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> along;
    for (std::size_t i = 0; i < places.size(); i += step) {
      along.push_back(places[i][axis]);
    }
    std::ranges::sort(along);
    const std::size_t left = 1 + along.size() / 100; // out at either end
    bulk.low[axis] = along[left];
    bulk.high[axis] = along[along.size() - 1 - left];
  }
  return bulk;
}

} // namespace

std::vector<std::string> strayVertexWarnings(const Scene& scene) {
  constexpr std::size_t fewest = 100;
  constexpr double farOut = 10.0;
  std::vector<std::string> warnings;
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    std::vector<Vec3> places;
    for (const Primitive& primitive : scene.meshes[mesh].primitives) {
      places.insert(places.end(), primitive.positions.begin(), primitive.positions.end());
    }
    if (places.size() < fewest) {
      continue;
    }
    const Bounds bulk = bulkOf(places);
    const auto awayOf = [&](const Vec3& place) {
      return glm::distance(place, glm::clamp(place, bulk.low, bulk.high));
    };
    const auto strays = static_cast<std::size_t>(std::ranges::count_if(
        places, [&](const Vec3& place) { return awayOf(place) > farOut * bulk.largestExtent(); }));
    if (strays > 0 && 100 * strays <= places.size()) {
      const Vec3 farthest = *std::ranges::max_element(places, {}, awayOf);
      warnings.push_back(fmt::format("meshes[{}]: {} of {} vertices stand more than ten times as far out as "
                                     "the others, one at ({:.3g}, {:.3g}, {:.3g}): "
                                     "the size of the character is measured with them; take them away",
                                     mesh, strays, places.size(), farthest.x, farthest.y, farthest.z));
    }
  }
  return warnings;
}

} // namespace stretch

#include "skinning/export/mesh_grid.h"

#include <algorithm>

#include <glm/common.hpp>

namespace stretch::skinning {

MeshGrid gridAround(std::span<const glm::vec3> places) {
  if (places.empty()) {
    return {};
  }
  glm::vec3 low = places.front();
  glm::vec3 high = low;
  for (const glm::vec3& place : places) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  const Vec3 half = 0.5 * (Vec3(high) - Vec3(low));
  const double size = std::max({half.x, half.y, half.z});
  return {0.5 * (Vec3(high) + Vec3(low)), size > 0.0 ? size : 1.0};
}

} // namespace stretch::skinning

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/types.h"

namespace stretch::assets {

/// Four joints that a vertex follows, heaviest first; weights sum to 1.
struct Influences {
  std::array<int, 4> joints{};
  std::array<double, 4> weights{1.0, 0.0, 0.0, 0.0};
};

struct SkinnedVertex {
  Vec3 position; ///< Bind pose, metres, model space.
  Vec3 normal;
  Vec3 color; ///< Linear, 0..1.
  Influences influences;
};

struct SkinnedMesh {
  std::vector<SkinnedVertex> vertices;
  std::vector<std::array<int, 3>> triangles;
};

} // namespace stretch::assets

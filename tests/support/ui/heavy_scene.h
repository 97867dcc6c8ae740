#pragma once

#include "core/scene/scene.h"

namespace stretch::test {

/// The scene with four triangles in the place of each, in its plane, as often as it takes to have more than
/// so many: looks the same and draws slowly. New vertices follow what the nearer corner follows.
[[nodiscard]] Scene withTriangles(Scene scene, std::size_t triangles);

} // namespace stretch::test

#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/scene.h"

namespace stretch::ui {

/// Number of triangles of all meshes of a scene.
[[nodiscard]] std::size_t triangleCount(const std::vector<Mesh>& meshes);

/// Meshes of the same shape with about so many triangles in all, for pictures of a character that moves:
/// vertices in a cell of space that follow the same joint most become one, which stands where the first of
/// them stands and follows what that one follows; triangles that collapse are gone. Of textures the vertex
/// keeps its own place. Same meshes, primitives, materials and morph targets, in their order. Meshes that
/// have no more triangles than that come back as they are.
[[nodiscard]] std::vector<Mesh> thinnedMeshes(const std::vector<Mesh>& meshes, std::size_t triangles);

} // namespace stretch::ui

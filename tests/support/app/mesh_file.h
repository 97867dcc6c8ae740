#pragma once

#include <filesystem>
#include <vector>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::test {

/// Writes a .gltf with one mesh and nothing else, and its .bin beside it.
void writeMeshFile(const std::filesystem::path& path, const std::vector<Vec3>& positions,
                   const std::vector<Triangle>& triangles);

} // namespace stretch::test

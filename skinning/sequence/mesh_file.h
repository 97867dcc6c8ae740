#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Positions and triangles of one mesh file; polygons are cut into fans. Everything is checked: indices are
/// in range, numbers are finite, there is at least one triangle.
struct MeshFile {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Wavefront OBJ: `v` and `f` lines (indices from 1, or negative from the end); everything else is ignored.
/// `name` is used in messages.
[[nodiscard]] Result<MeshFile> parseObj(std::string_view text, std::string_view name);

/// Stanford PLY, ascii or binary (either byte order): elements `vertex` (x, y, z) and `face` (a list of
/// indices); other elements and properties are stepped over.
[[nodiscard]] Result<MeshFile> parsePly(std::string_view bytes, std::string_view name);

/// Whether the extension is .obj or .ply.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& path);

/// .obj or .ply, by the extension.
[[nodiscard]] Result<MeshFile> readMeshFile(const std::filesystem::path& path);

/// Whether the extension is .pc2.
[[nodiscard]] bool isPointCache(const std::filesystem::path& path);

/// Number of points that the header of a cache promises. An error for bytes that are not a point cache.
[[nodiscard]] Result<std::uint64_t> pointsOfCache(const std::filesystem::path& cache);

} // namespace stretch::skinning

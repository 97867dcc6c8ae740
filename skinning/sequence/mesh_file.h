#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Largest magnitude of a number that readers of meshes take: it leaves room for squares in single precision.
inline constexpr double largestCoordinate = 1e15;

/// Whether a place can be worked with: each coordinate is a number of at most largestCoordinate.
[[nodiscard]] inline bool isUsablePlace(const glm::vec3& place) {
  constexpr auto largest = static_cast<float>(largestCoordinate);
  return std::abs(place.x) <= largest && std::abs(place.y) <= largest && std::abs(place.z) <= largest;
}

/// Polygons of a mesh, one after the other.
struct Polygons {
  std::vector<std::uint32_t> corners; ///< Vertices.
  std::vector<std::size_t> ends;      ///< Behind the last corner of each polygon, three or more after the end
                                      ///< before it.

  friend bool operator==(const Polygons&, const Polygons&) = default;
};

/// Positions and triangles of one mesh file. Everything is checked: indices are in range, numbers are finite,
/// there is at least one triangle.
struct MeshFile {
  std::vector<glm::vec3> positions;
  Polygons polygons;
  std::vector<Triangle> cuts; ///< Triangles that the polygons were cut into, as places among their corners.
  std::vector<Triangle> triangles; ///< The same as vertices.
  // Normals of a PLY, one for each vertex, empty where the file has none (an OBJ's: see surfaceOfObj).
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> texCoords; ///< Counted as in the file: v upwards.
  std::vector<glm::vec4> colors;    ///< Linear.
};

/// Wavefront OBJ: `v` and `f` lines (indices from 1, or negative from the end); everything else is ignored.
/// `name` is used in messages.
[[nodiscard]] Result<MeshFile> parseObj(std::string_view text, std::string_view name);

/// Stanford PLY, ascii or binary (either byte order): elements `vertex` (x, y, z) and `face` (a list of
/// indices); other elements and properties are stepped over.
[[nodiscard]] Result<MeshFile> parsePly(std::string_view bytes, std::string_view name);

/// Cuts each polygon that was read into two triangles fewer than it has corners: a fan around the first
/// corner where that covers the polygon, as it does a convex one; else ears are cut off, so that notches stay
/// open.
void cutIntoTriangles(MeshFile& mesh);

/// Whether the extension is .obj or .ply.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& path);

/// .obj or .ply, by the extension.
[[nodiscard]] Result<MeshFile> readMeshFile(const std::filesystem::path& path);

/// Looks of a mesh that readMeshFile read from `path`; null where the file says nothing of it.
[[nodiscard]] std::shared_ptr<const gltf::MeshSurface> surfaceOfMeshFile(const std::filesystem::path& path,
                                                                         const MeshFile& mesh,
                                                                         std::vector<std::string>& warnings);

/// Whether the extension is .glb, .gltf or .vrm.
[[nodiscard]] bool isGltfFile(const std::filesystem::path& path);

/// Whether the extension is one of meshes that a point cache can move: .obj, .ply, or a glTF's.
[[nodiscard]] bool isBaseMesh(const std::filesystem::path& path);

/// Number of vertices that a point cache of this mesh has. An error for a file that cannot be read.
[[nodiscard]] Result<std::size_t> verticesOfBase(const std::filesystem::path& path);

/// Whether the extension is .pc2 or .mdd.
[[nodiscard]] bool isPointCache(const std::filesystem::path& path);

/// Number of points that the header of a cache promises. An error for a file that is not a point cache, or
/// shorter than it says.
[[nodiscard]] Result<std::uint64_t> pointsOfCache(const std::filesystem::path& cache);

} // namespace stretch::skinning

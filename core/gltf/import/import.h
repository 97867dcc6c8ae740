#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/gltf/source/pictures.h"
#include "core/gltf/source/problems.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

// The parts of the import. Each needs a source whose structure, graph, buffers and accessors were validated
// without errors, and reports what it finds to `problems`; after an error its answer is not to be used.

/// Nodes, roots, skins, meshes, materials, images, cameras and the humanoid table.
[[nodiscard]] Scene importScene(const Source& source, Problems& problems,
                                Pictures pictures = Pictures::decoded);

/// One clip for each animation of the file, in its order; channels that drive nothing we know are left out.
[[nodiscard]] std::vector<Clip> importClips(const Source& source, const Scene& scene, Problems& problems);

/// Values that may be decoded at most of all meshes, or of all clips: a small file that names the same bytes
/// over and over must not fill the memory (docs/trust.md, Limits).
class DecodeBudget {
public:
  explicit DecodeBudget(const Source& source);
  /// False when the file asks for more than it may.
  [[nodiscard]] bool take(std::size_t values) {
    const bool isLeft = values <= left_;
    left_ -= isLeft ? values : left_;
    return isLeft;
  }

private:
  std::size_t left_;
};

// Parts of importScene.
[[nodiscard]] std::vector<Mesh> importMeshes(const Source& source, const Scene& scene, Problems& problems);
[[nodiscard]] std::vector<Material> importMaterials(const Source& source, Problems& problems);
[[nodiscard]] std::vector<Image> importImages(const Source& source, const std::vector<Material>& materials,
                                              Problems& problems, Pictures pictures = Pictures::decoded);
/// The bytes of an entry of "images" as they lie in the file; nothing when they cannot be read.
[[nodiscard]] std::optional<Bytes> encodedImage(const Source& source, const Json& image);
[[nodiscard]] std::map<std::string, NodeIndex> importHumanoid(const Source& source, Problems& problems);

/// The nodes that carry a camera; one that says nothing usable is left out with a warning.
[[nodiscard]] std::vector<SceneCamera> importCameras(const Source& source, Problems& problems);

/// Whether a primitive of "meshes" becomes one of Mesh::primitives: it has positions, and triangles.
[[nodiscard]] bool holdsTriangles(const Json& primitive);

/// The accessors that primitives name as WEIGHTS_0 and WEIGHTS_1.
[[nodiscard]] std::set<int> weightAccessors(const Json& json);

/// The accessors of the places of a mesh's triangles, each with the first of Mesh::primitives that has it.
[[nodiscard]] std::map<int, std::size_t> trianglesByPlaces(const Json& mesh);

/// Index of the TEXCOORD set that a texture of the material uses; nothing without that texture.
[[nodiscard]] std::optional<int> baseColorTexCoord(const Source& source, int material);
[[nodiscard]] std::optional<int> emissiveTexCoord(const Source& source, int material);

} // namespace stretch::gltf

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/gltf/json/json_document.h"
#include "core/interchange/figure.h"
#include "core/interchange/glb_parts.h"

namespace stretch::interchange {

/// What became of the meshes of a scene.
struct MeshNotes {
  std::vector<int> nodeOfMesh; ///< For each mesh of the scene the first node that shows it, -1 without.
  bool spansRoots = false;   ///< Joints of one skin hang under several roots, and glTF asks for a common one.
  std::size_t lostBones = 0; ///< Bones of skins that no node stands for.
  std::size_t unweightedVertices = 0; ///< Vertices of skinned meshes that no bone moves: they stay where they
                                      ///< are.
};

/// Adds the meshes with their skins and morph targets, and names them in `nodes`, the JSON of the figure's
/// nodes (behind which nodes may be added: joints that vertices without weights follow, and second meshes of
/// one node). `materials`: the glTF material of each of the scene's, -1 without.
[[nodiscard]] MeshNotes addMeshes(const aiScene& scene, const Figure& figure,
                                  const std::vector<int>& materials, std::vector<gltf::JsonDocument>& nodes,
                                  GlbParts& parts);

/// Adds the scene's materials with the textures that are inside the file or beside it, as PNG or JPEG; those
/// of other kinds are made PNG. One line of warning for each that cannot be found or read.
[[nodiscard]] std::vector<int> addMaterials(const aiScene& scene, const std::filesystem::path& file,
                                            GlbParts& parts, std::vector<std::string>& warnings);

} // namespace stretch::interchange

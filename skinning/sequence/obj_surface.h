#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/source/source.h"
#include "skinning/sequence/mesh_file.h"

namespace stretch::skinning {

/// Looks of an OBJ file's mesh beyond positions: normals (`vn`), texture coordinates (`vt`), groups of
/// one material (`usemtl`, named by `o` and `g`), materials of its MTL files. `mesh` is what parseObj made of
/// the same text. Vertices are split where the corners of faces differ, and stand in the order of their
/// places. Null for a file that holds positions and faces alone. What cannot be read is told in `warnings`.
[[nodiscard]] std::shared_ptr<const gltf::MeshSurface> surfaceOfObj(std::string_view text,
                                                                    const MeshFile& mesh,
                                                                    const std::filesystem::path& path,
                                                                    std::vector<std::string>& warnings);

/// The materials of MTL files as glTF has them, in the order of `names`; those that no file describes keep
/// their name and are grey. Kd and map_Kd, d and Tr, Ke and map_Ke, Ns or Pr, Pm, norm; images are looked for
/// beside the MTL file and below, nowhere else.
[[nodiscard]] gltf::Source materialsOfMtl(const std::vector<std::filesystem::path>& files,
                                          const std::vector<std::string>& names,
                                          std::vector<std::string>& warnings);

} // namespace stretch::skinning

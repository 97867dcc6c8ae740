#pragma once

#include <memory>

#include "core/anim/frame_state.h"
#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/source/source.h"

namespace stretch::skinning {

/// Looks of the drawn meshes of a file, vertices in the order of skinnedPositions, each a place of its
/// own; normals as they are in `first`. Images that cannot be read are told in `warnings`.
[[nodiscard]] gltf::MeshSurface surfaceOf(const gltf::Loaded& loaded, const FrameState& first,
                                          std::vector<std::string>& warnings);

} // namespace stretch::skinning

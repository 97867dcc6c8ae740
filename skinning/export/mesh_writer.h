#pragma once

#include <cstddef>

#include "core/gltf/json_document.h"
#include "skinning/export/gltf_buffers.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Writes the bind mesh with its weights, materials and images, and a node with skin 0 for each mesh at the
/// beginning of "nodes". Meshes of the source that share no vertex stay meshes of their own; otherwise there
/// is one, with a primitive for each material, and all share their vertices. Answers the number of nodes.
std::size_t writeMeshes(const SkinnedSequence& sequence, bool quantise, gltf::Json& json,
                        GltfBuffers& buffers);

} // namespace stretch::skinning

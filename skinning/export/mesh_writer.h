#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/gltf/write/new_file.h"
#include "skinning/export/mesh_grid.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

struct MeshEncoding {
  bool quantiseWeights = false; ///< Whether weights become normalised 16-bit integers.
  std::optional<MeshGrid> grid; ///< Places on it, normals in 8 bits, and texture coordinates and colours in
                                ///< 16 where they lie in 0..1 (KHR_mesh_quantization). Empty: all as floats.
};

struct WrittenMeshes {
  std::size_t nodes = 0;             ///< The first of the file.
  std::vector<std::uint32_t> places; ///< For each vertex, primitive by primitive, the vertex of the sequence.
};

/// Writes the bind mesh with its weights, materials and images, and a node with skin 0 for each mesh, into a
/// file that has no node yet. Meshes of the source that share no vertex stay meshes of their own; otherwise
/// there is one, with a primitive for each material, and all share their vertices. Vertices on more than four
/// bones make a second set of joints and weights.
WrittenMeshes writeMeshes(const SkinnedSequence& sequence, const MeshEncoding& encoding, gltf::NewFile& file);

} // namespace stretch::skinning

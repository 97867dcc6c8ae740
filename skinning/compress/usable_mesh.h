#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// A sequence as fits and measures need it: without vertices of no triangle, and with triangles that are
/// wound alike and outwards where neighbours were wound against each other.
struct UsableMesh {
  std::optional<MeshSequence> changed; ///< Empty: the sequence is usable as it is.
  std::vector<std::uint32_t> vertices; ///< Vertices of the sequence, one for each vertex of `changed`,
                                       ///< ascending.
  std::vector<std::string> warnings;   ///< Changes that were made, one line each.
};

[[nodiscard]] UsableMesh usableMesh(const MeshSequence& sequence);

/// Gives what was made of `usable.changed` all vertices of the sequence again; those of no triangle follow
/// the first bone.
void giveBackVertices(const UsableMesh& usable, const MeshSequence& sequence, SkinnedSequence& skinned);

} // namespace stretch::skinning

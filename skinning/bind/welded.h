#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// For each vertex the first vertex that lies where it lies, within a hundred-thousandth of the mesh: files
/// split vertices along seams and hard edges.
[[nodiscard]] std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions);

} // namespace stretch::skinning

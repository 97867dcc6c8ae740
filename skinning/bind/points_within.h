#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// The shells that points lie within: of three lines through a point, along the axes, two come out of the
/// shell as often on either side as they went in. `shells`: for each vertex the number of its shell. For each
/// point the shells, ascending.
[[nodiscard]] std::vector<std::vector<std::size_t>> shellsAround(std::span<const glm::vec3> positions,
                                                                 const std::vector<Triangle>& triangles,
                                                                 const std::vector<std::size_t>& shells,
                                                                 const std::vector<Vec3>& points);

} // namespace stretch::skinning

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "skinning/bind/bone_lines.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Pieces of a mesh that nothing joins: vertices of one piece are joined by triangles or lie at one place
/// (`welded`, see weldedVertices). For each vertex the number of its piece, from 0.
[[nodiscard]] std::vector<std::size_t> shellsOf(const std::vector<std::uint32_t>& welded,
                                                const std::vector<Triangle>& triangles);

/// A shell of its own (a helmet, a plate, an eye, a bone of a skeleton) moves as one piece where one bone
/// alone runs in it, or none and it is small: all of its vertices get the weights of that bone, or of the
/// shell's mean. Shells in which several bones run bend.
void stiffenShells(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                   const std::vector<std::uint32_t>& welded, const std::vector<BoneLine>& lines,
                   std::size_t joints, std::vector<Influences>& weights);

} // namespace stretch::skinning

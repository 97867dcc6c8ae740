#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/scene/mesh_sequence.h"
#include "rig/retarget/skeleton.h"

namespace stretch::app {

/// Vertices of an arm.
struct ArmParts {
  std::vector<std::size_t> forearm;
  std::vector<std::size_t> hand;       ///< Without what it holds, if it has a surface of its own.
  std::vector<std::size_t> held;       ///< Rigid meshes that hang on the hand of a skinned body.
  std::vector<Triangle> handTriangles; ///< Triangles of `hand`.
};

/// The surface of a biped in parts. Vertices, counted as skinnedPositions does, follow the part of the node
/// that moves them most: the trunk is what hangs on the hips, but for arms from the shoulder's joint on and
/// legs.
struct BodyParts {
  std::vector<Triangle> trunk;        ///< And the head, with those that reach over to upper arms and thighs.
  std::vector<bool> isOfHead;         ///< For each triangle of the trunk.
  std::array<ArmParts, 2> arms;       ///< Left, right.
  std::vector<std::size_t> lowerLegs; ///< Shins and feet.
};

[[nodiscard]] BodyParts bodyPartsOf(const rig::Skeleton& skeleton);

/// At most so many of the vertices, in even steps.
[[nodiscard]] std::vector<std::size_t> thinned(const std::vector<std::size_t>& vertices, std::size_t most);

} // namespace stretch::app

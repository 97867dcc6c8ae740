#pragma once

#include <span>
#include <vector>

#include "skinning/bind/bone_lines.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Shares weights between the two sides of a skeleton that is the same on both: each vertex that has another
/// at its mirrored place gets the mean of its own weights and of the other's, the joints mirrored. The mirror
/// stands across one axis, in the middle of the joints, within 1e-4 of the body's size (of its box's
/// diagonal; for vertices 1e-5). Of any other skeleton, and of vertices without such another, nothing
/// changes.
void mirrorWeights(std::span<const glm::vec3> positions, const std::vector<BindJoint>& joints,
                   std::vector<Influences>& weights);

} // namespace stretch::skinning

#pragma once

#include <vector>

#include "core/scene/mesh_sequence.h"

// Internal to skinning/body: whether a body has limbs.

namespace stretch::skinning {

/// Whether slices across the body fall into several pieces, each a fair share of its slice's area, for a
/// fifth of the length. `along`: where each vertex lies, 0..1.
[[nodiscard]] bool isBranched(const std::vector<double>& along, const std::vector<double>& areas,
                              const std::vector<Triangle>& triangles);

/// Whether the surface has a tip besides the two that the distances run between: a place farther from the one
/// than all around it, by more than the limb that leads there is thick. `distances`: over the surface from
/// one tip; places that cannot be reached are infinite and do not count.
[[nodiscard]] bool hasLimbBeside(const std::vector<double>& distances,
                                 const std::vector<double>& vertexDiameters,
                                 const std::vector<Triangle>& triangles);

} // namespace stretch::skinning

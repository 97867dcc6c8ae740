#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace stretch {

/// A line for each mesh a few of whose vertices, a hundredth at most, stand more than ten times as far out as
/// all others reach: they are no part of a body, and make sizes that are measured by the mesh too large.
/// Meshes of less than a hundred vertices have none.
[[nodiscard]] std::vector<std::string> strayVertexWarnings(const Scene& scene);

} // namespace stretch

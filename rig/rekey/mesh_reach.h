#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace stretch::rig {

/// How far from each node the mesh gets that follows it, as much as it follows it, in the node's own units: a
/// wrong turn of the node moves the mesh by that much times the angle. One for each node; 0 where no mesh
/// follows.
[[nodiscard]] std::vector<double> meshReach(const Scene& scene);

} // namespace stretch::rig

#pragma once

#include <cstddef>
#include <set>

#include "core/scene/scene.h"

namespace stretch {

/// Nodes that are a joint of any skin.
[[nodiscard]] std::set<NodeIndex> skinJoints(const Scene& scene);

/// Vertices of all meshes.
[[nodiscard]] std::size_t vertexCount(const Scene& scene);

} // namespace stretch

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/scene/mesh_sequence.h"

namespace stretch::bench {

// CGAL (package libcgal-dev) beside this program, where it was there when the bench was built; else nothing
// is done. It is a peer to measure against and part of nothing else.

[[nodiscard]] bool hasCgal();

/// Shape diameters with 64 rays for each face in a cone of 120 degrees, smoothed as it does.
void cgalThickness(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles);

/// Distances of all vertices from each of the sources by the heat method, built once.
void cgalDistances(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                   const std::vector<std::uint32_t>& sources);

} // namespace stretch::bench

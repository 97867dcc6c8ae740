#pragma once

#include "core/gltf/source/problems.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// Types, ranges and indices of everything in the JSON that the schema lists, the version, and the required
/// extensions. After a pass without errors the other parts of the reader rely on them.
void validateStructure(const Json& json, Problems& problems);

/// Validates what the schema cannot say of nodes, scenes and skins: one parent each, no loops, matrix or TRS,
/// joints there. The structure has to be validated.
void validateGraph(const Json& json, Problems& problems);

} // namespace stretch::gltf

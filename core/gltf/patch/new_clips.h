#pragma once

#include <vector>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// The source with clips appended to its animations, and nothing else changed: nodes that they move by tracks
/// and that the file places by a matrix are placed by its parts, as animated nodes have to be. The tracks are
/// as Edits wants them.
[[nodiscard]] Result<Source> withNewClips(const Source& source, const std::vector<Clip>& clips);

} // namespace stretch::gltf

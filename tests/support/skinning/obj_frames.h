#pragma once

#include <filesystem>
#include <string>

#include "core/scene/mesh_sequence.h"

namespace stretch::test {

/// Writes a folder of OBJ frames: NAME-1.obj, NAME-2.obj, ...
void writeObjFrames(const MeshSequence& sequence, const std::filesystem::path& folder,
                    const std::string& name);

} // namespace stretch::test

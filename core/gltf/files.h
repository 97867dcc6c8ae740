#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/gltf/glb.h"

namespace stretch::gltf {

/// All bytes of a file. Error: not there, no regular file, not readable, 4 GiB or more.
[[nodiscard]] Result<Bytes> readFile(const std::filesystem::path& path);

} // namespace stretch::gltf

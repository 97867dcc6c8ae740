#pragma once

#include <filesystem>
#include <optional>

#include "core/gltf/source/problems.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// The file as it is, its chunks and JSON taken apart, no buffer read yet except the BIN chunk. Nothing, and
/// an error in `problems`, when that fails.
[[nodiscard]] std::optional<Source> readSource(const std::filesystem::path& path, Problems& problems);

/// Fills `source.buffers`: data URIs decoded, files beside read. A file that is missing is a warning here and
/// an error where an accessor needs it. The JSON's structure has to be validated.
void readBuffers(Source& source, Problems& problems);

} // namespace stretch::gltf

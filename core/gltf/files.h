#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/gltf/glb.h"

namespace stretch::gltf {

/// All bytes of a file. Error: not there, no regular file, not readable, 4 GiB or more.
[[nodiscard]] Result<Bytes> readFile(const std::filesystem::path& path);

struct OutputFile {
  std::filesystem::path path;
  Bytes bytes;
};

/// Writes all files or none: each beside its place under a temporary name, then renamed in their order, so
/// that the file that refers to the others comes last. Missing folders are made. On failure what was made is
/// removed again.
[[nodiscard]] Status writeFiles(const std::vector<OutputFile>& files);

} // namespace stretch::gltf

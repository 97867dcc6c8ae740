#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/base/result.h"
#include "core/interchange/file_kind.h"

namespace stretch::interchange {

/// A file of another program as glTF.
struct Converted {
  Bytes glb;                         ///< A binary glTF file, self-contained.
  std::vector<std::string> warnings; ///< One line each: what was left out, or is not as in the other program.
};

/// Makes glTF of a file in a process of its own, so that neither a crash nor an endless loop of the library
/// that reads it costs this one anything. That process may use 64 bytes for each byte of the file and 800 MB,
/// 60 seconds of processor time, and may be silent for 120. Metres, Y up; the same bytes for the same file.
/// Error: the file cannot be read, holds nothing to show, or asks for more than that.
[[nodiscard]] Result<Converted> convertedInProcess(const std::filesystem::path& file, Format format,
                                                   std::uintmax_t fileBytes);

/// Makes glTF of a file in this process; for the process that the function above starts.
[[nodiscard]] Result<Converted> converted(const std::filesystem::path& file);

} // namespace stretch::interchange

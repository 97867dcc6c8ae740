#pragma once

#include <array>
#include <filesystem>
#include <optional>

namespace stretch::app {

/// A clip that comes with the program.
struct BundledClip {
  const char* file;    ///< In the bundled folder.
  const char* picture; ///< Beside it.
  const char* name;
  const char* line;      ///< Line that says what can be tried on it.
  const char* commandId; ///< Opens it.
};

[[nodiscard]] const std::array<BundledClip, 3>& bundledClips();

/// The folder of the bundled clips as seen from a program's own folder: that of an installation, or that of
/// the sources it was built from. Nothing where there is neither.
[[nodiscard]] std::optional<std::filesystem::path> bundledFolder(const std::filesystem::path& programFolder);

/// Folder of the program that runs.
[[nodiscard]] std::optional<std::filesystem::path> bundledFolder();

} // namespace stretch::app

#pragma once

#include <filesystem>
#include <optional>

namespace stretch::app {

/// The folder of the bundled clips as seen from a program's own folder: that of an installation, or that of
/// the sources it was built from. Nothing where there is neither.
[[nodiscard]] std::optional<std::filesystem::path> bundledFolder(const std::filesystem::path& programFolder);

/// Folder of the program that runs.
[[nodiscard]] std::optional<std::filesystem::path> bundledFolder();

/// Whether a file lies in the folder of the bundled clips.
[[nodiscard]] bool isBundled(const std::filesystem::path& file);

} // namespace stretch::app

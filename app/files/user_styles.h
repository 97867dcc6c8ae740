#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "rig/styles/style.h"

namespace stretch::app {

// Styles of the user's own, each a JSON file (docs/styles.md) in the folder "styles" of the configuration
// folder.

/// Reads a file that holds a style; an error names the file and the key.
[[nodiscard]] Result<rig::Style> loadStyle(const std::filesystem::path& path);

/// Writes a style as such a file.
[[nodiscard]] Status saveStyle(const rig::Style& style, const std::filesystem::path& path);

[[nodiscard]] std::filesystem::path stylesFolder();

/// The user's styles by name, from files that can be read as one.
[[nodiscard]] std::vector<rig::Style> userStyles(const std::filesystem::path& folder);

/// The built-in styles, then the user's.
[[nodiscard]] std::vector<rig::Style> allStyles(const std::filesystem::path& folder);

/// The style of a name, or in a file where `text` ends with ".json". An error lists the names.
[[nodiscard]] Result<rig::Style> findStyle(const std::string& text, const std::filesystem::path& folder);

} // namespace stretch::app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/panels/ui_state.h"

namespace stretch::ui {

/// Extensions (lower case, with the dot) that a purpose shows; empty: folders only.
[[nodiscard]] std::vector<std::string> extensionsOf(FilePurpose purpose);
[[nodiscard]] bool isSaving(FilePurpose purpose);
/// "Open a character", "Save as" ...
[[nodiscard]] const char* titleOf(FilePurpose purpose);

/// Folders first, then the files that the purpose shows, each by name without regard to case; hidden ones are
/// left out.
[[nodiscard]] Result<std::vector<FileEntry>> listFolder(const std::filesystem::path& folder,
                                                        FilePurpose purpose);

/// What was typed as a path: absolute, from the home folder ("~/clips"), or relative to the folder that is
/// shown.
[[nodiscard]] std::filesystem::path typedPath(const std::filesystem::path& folder, const std::string& typed);

/// The user's home folder, or the root where there is none.
[[nodiscard]] std::filesystem::path homeFolder();

/// "1.4 MB".
[[nodiscard]] std::string sizeText(std::uintmax_t bytes);

/// Adds the purpose's first extension where the name has none of them.
[[nodiscard]] std::filesystem::path withExtension(std::filesystem::path path, FilePurpose purpose);

} // namespace stretch::ui

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/panels/state/ui_state.h"

namespace stretch::ui {

/// Extensions (lower case, with the dot) that a purpose shows; empty: folders only.
[[nodiscard]] std::vector<std::string> extensionsOf(FilePurpose purpose);
/// Kinds of files that a purpose lets one choose from, the first of them everything that it shows; empty
/// where there is nothing to choose.
struct FileType {
  const char* title;
  std::vector<std::string> extensions;
};
[[nodiscard]] std::vector<FileType> fileTypesOf(FilePurpose purpose);
/// Whether a file has one of these extensions, in whatever case.
[[nodiscard]] bool hasExtension(const std::filesystem::path& path,
                                const std::vector<std::string>& extensions);
[[nodiscard]] bool isSaving(FilePurpose purpose);
/// "Open a character", "Save as" ...
[[nodiscard]] const char* titleOf(FilePurpose purpose);

/// Folders first, then the files that the purpose shows, each by name without regard to case; hidden ones are
/// left out.
[[nodiscard]] Result<std::vector<FileEntry>> listFolder(const std::filesystem::path& folder,
                                                        FilePurpose purpose);

/// Returns what was typed as a path: absolute, from the home folder ("~/clips"), or relative to the folder
/// that is shown.
[[nodiscard]] std::filesystem::path typedPath(const std::filesystem::path& folder, const std::string& typed);

/// The user's home folder, or the root where there is none.
[[nodiscard]] std::filesystem::path homeFolder();

/// Folders of files that were open lately, the last one first, each once, at most `most`.
[[nodiscard]] std::vector<std::filesystem::path>
recentFolders(const std::vector<std::filesystem::path>& recentFiles, std::size_t most);

/// "1.4 MB".
[[nodiscard]] std::string sizeText(std::uintmax_t bytes);

/// Adds the purpose's first extension where the name has none of them.
[[nodiscard]] std::filesystem::path withExtension(std::filesystem::path path, FilePurpose purpose);

} // namespace stretch::ui

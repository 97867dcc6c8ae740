#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stretch::app {

/// Folders of a user's own files: $XDG_CONFIG_HOME/stretch-engine and $XDG_STATE_HOME/stretch-engine, or
/// their defaults below the home folder; below the temporary folder where there is no home.
[[nodiscard]] std::filesystem::path configFolder();
[[nodiscard]] std::filesystem::path stateFolder();

/// The user's documents: the folder that the desktop names (`XDG_DOCUMENTS_DIR` in user-dirs.dirs), else
/// Documents below the home folder, else the home folder; the temporary folder where none can be written.
[[nodiscard]] std::filesystem::path documentsFolder();
/// Whether the folder is there and this user may make files in it. An empty path is the current folder.
[[nodiscard]] bool isWritableFolder(const std::filesystem::path& folder);

/// The file in `folder` that something of the user's own is kept in by its name, with what a file's name may
/// not have replaced.
[[nodiscard]] std::filesystem::path fileOfName(const std::filesystem::path& folder, const std::string& name);
/// The files in a folder that end with ".json", in no order; none where it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> jsonFilesIn(const std::filesystem::path& folder);

/// A short name for a path that is the same at every start: "punch-1f03a9c2".
[[nodiscard]] std::string nameFor(const std::filesystem::path& path);

/// State of a file, to tell later whether another program changed it.
struct FileStamp {
  std::filesystem::file_time_type time{};
  std::uintmax_t bytes = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
[[nodiscard]] std::optional<FileStamp> stampOf(const std::filesystem::path& path);

} // namespace stretch::app

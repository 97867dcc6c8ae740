#include "app/files/user_files.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "core/base/hash.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;

fs::path userFolder(const char* variable, const char* belowHome) {
  const char* own = std::getenv(variable);
  if (own != nullptr && own[0] == '/') {
    return fs::path(own) / "stretch-engine";
  }
  const char* home = std::getenv("HOME");
  if (home != nullptr && home[0] == '/') {
    return fs::path(home) / belowHome / "stretch-engine";
  }
  std::error_code ignored;
  return fs::temp_directory_path(ignored) / "stretch-engine";
}

fs::path homeOrNone() {
  const char* const home = std::getenv("HOME");
  return home != nullptr && home[0] == '/' ? fs::path(home) : fs::path();
}

/// The folder in a line XDG_DOCUMENTS_DIR="$HOME/Dokumente" of the desktop's file; empty where there is none.
fs::path namedDocuments(const fs::path& home) {
  constexpr std::string_view begin = "XDG_DOCUMENTS_DIR=\"";
  constexpr std::string_view below = "$HOME/";
  std::ifstream file(configFolder().parent_path() / "user-dirs.dirs");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(begin) || line.back() != '"') {
      continue;
    }
    const std::string named = line.substr(begin.size(), line.size() - begin.size() - 1);
    return named.starts_with(below) ? home / named.substr(below.size()) : fs::path(named);
  }
  return {};
}

} // namespace

fs::path configFolder() {
  return userFolder("XDG_CONFIG_HOME", ".config");
}
fs::path stateFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state");
}

fs::path documentsFolder() {
  const fs::path home = homeOrNone();
  for (const fs::path& folder : {namedDocuments(home), home / "Documents", home}) {
    if (folder.is_absolute() && isWritableFolder(folder)) {
      return folder;
    }
  }
  std::error_code ignored;
  return fs::temp_directory_path(ignored);
}

bool isWritableFolder(const fs::path& folder) {
  std::error_code ignored;
  const fs::path named = folder.empty() ? fs::path(".") : folder;
  return fs::is_directory(named, ignored) && ::access(named.c_str(), W_OK | X_OK) == 0;
}

fs::path fileOfName(const fs::path& folder, const std::string& name) {
  const auto isRefused = [](char c) {
    return static_cast<unsigned char>(c) < ' ' ||
           std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
  };
  std::string file = name;
  std::ranges::replace_if(file, isRefused, '_');
  return folder / (file + ".json");
}

std::vector<fs::path> jsonFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (entry->path().extension() == ".json") {
      files.push_back(entry->path());
    }
  }
  return files;
}

std::string nameFor(const fs::path& path) {
  std::error_code ignored;
  const std::string full = fs::absolute(path, ignored).lexically_normal().string();
  Hash hash;
  hash.add(full);
  return fmt::format("{}-{:016x}", path.stem().string(), hash.value());
}

std::optional<FileStamp> stampOf(const fs::path& path) {
  std::error_code problem;
  FileStamp stamp;
  stamp.time = fs::last_write_time(path, problem);
  if (problem) {
    return std::nullopt;
  }
  stamp.bytes = fs::file_size(path, problem);
  return problem ? std::nullopt : std::optional(stamp);
}

} // namespace stretch::app

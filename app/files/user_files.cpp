#include "app/files/user_files.h"

#include <cstdlib>

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

} // namespace

fs::path configFolder() {
  return userFolder("XDG_CONFIG_HOME", ".config");
}
fs::path stateFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state");
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

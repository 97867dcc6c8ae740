#include "app/files/user_files.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

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

} // namespace stretch::app

namespace stretch {

namespace fs = std::filesystem;

std::optional<std::string> readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  std::ostringstream text;
  text << file.rdbuf();
  return file.bad() ? std::nullopt : std::optional(text.str());
}

Status writeText(const fs::path& path, const std::string& text) {
  std::error_code problem;
  fs::create_directories(path.parent_path(), problem);
  const fs::path temporary = path.string() + fmt::format(".{}.tmp", getpid());
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file << text;
    file.flush();
    if (!file) {
      fs::remove(temporary, problem);
      return Error{"cannot be written", path.string(), "check the folder's permissions and the free space"};
    }
  }
  fs::rename(temporary, path, problem);
  if (problem) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return Error{"cannot be replaced: " + problem.message(), path.string(), "check the folder's permissions"};
  }
  return Success{};
}

} // namespace stretch

namespace stretch::app {

std::string nameFor(const fs::path& path) {
  std::error_code ignored;
  const std::string full = fs::absolute(path, ignored).lexically_normal().string();
  std::uint64_t hash = 1469598103934665603ULL; // FNV-1a.
  for (const char c : full) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return fmt::format("{}-{:016x}", path.stem().string(), hash);
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

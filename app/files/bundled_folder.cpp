#include "app/files/bundled_folder.h"

#include <system_error>

namespace stretch::app {

namespace fs = std::filesystem;

std::optional<fs::path> bundledFolder(const fs::path& programFolder) {
  std::error_code ignored;
  for (const char* place : {"../share/stretch-engine", "../../assets", "../../../assets"}) {
    const fs::path folder = (programFolder / place).lexically_normal();
    if (fs::exists(folder / "dummy.glb", ignored)) {
      return folder;
    }
  }
  return std::nullopt;
}

std::optional<fs::path> bundledFolder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? std::nullopt : bundledFolder(program.parent_path());
}

bool isBundled(const fs::path& file) {
  std::error_code failed;
  const std::optional<fs::path> folder = bundledFolder();
  return folder && fs::equivalent(fs::absolute(file, failed).parent_path(), *folder, failed);
}

} // namespace stretch::app

#include "app/bundled_files.h"

#include "app/commands/table/command_ids.h"

namespace stretch::app {

namespace fs = std::filesystem;

const std::array<BundledClip, 3>& bundledClips() {
  static constexpr std::array<BundledClip, 3> clips{
      {{"dummy.glb", "dummy.png", "One-two punch", "A jab that reaches three arms far.",
        command::bundledPunch},
       {"dummy_swing.glb", "dummy_swing.png", "Baseball swing", "Two hands, one bat, twice the reach.",
        command::bundledSwing},
       {"dummy_leap.glb", "dummy_leap.png", "Leap and landing", "The whole body stretches over ledges.",
        command::bundledLeap}}};
  return clips;
}

std::optional<fs::path> bundledFolder(const fs::path& programFolder) {
  std::error_code ignored;
  for (const char* place : {"../share/stretch-engine", "../../assets", "../../../assets"}) {
    const fs::path folder = (programFolder / place).lexically_normal();
    if (fs::exists(folder / bundledClips().front().file, ignored)) {
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

} // namespace stretch::app

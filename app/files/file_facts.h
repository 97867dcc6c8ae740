#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stretch::app {

/// Facts that a file tells of itself before it is opened: read from its head alone, buffers and images
/// untouched.
struct FileFacts {
  struct ClipFacts {
    std::string name; ///< Empty where the file gives none.
    double seconds = 0.0;
  };
  std::string kind; ///< "Binary glTF", "VRM avatar", "OBJ mesh"; empty: not a file to open.
  std::uintmax_t bytes = 0;
  bool isScene = false; ///< The numbers below were read.
  int meshes = 0;
  int joints = 0; ///< Joints of all skins together, each once.
  std::vector<ClipFacts> clips;
  bool carriesWork = false; ///< Saved by this program, with trails and settings.
  std::string problem;      ///< Why nothing more can be said.
};

/// Never fails: what cannot be read is told in `problem`.
[[nodiscard]] FileFacts factsOf(const std::filesystem::path& path);

} // namespace stretch::app

#include <cstdio>
#include <filesystem>

#include "assets/dummy/dummy.h"
#include "core/base/file.h"

/// make-dummy FOLDER: writes the bundled characters.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make-dummy FOLDER\n", stderr);
    return 2;
  }
  for (const stretch::assets::BundledFile& file : stretch::assets::bundledFiles()) {
    const std::filesystem::path path = std::filesystem::path(argv[1]) / file.name;
    const std::vector<std::uint8_t> glb = stretch::assets::writeGlb(file.character);
    if (const stretch::Status written = stretch::writeFile(path, glb); !written) {
      std::fprintf(stderr, "%s\n", written.error().line().c_str());
      return 1;
    }
  }
  return 0;
}

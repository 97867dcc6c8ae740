#include <cstdio>

#include "assets/dummy/dummy.h"
#include "core/base/file.h"

/// make-dummy OUT.glb: writes the bundled character.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make-dummy OUT.glb\n", stderr);
    return 2;
  }
  const std::vector<std::uint8_t> glb = stretch::assets::writeGlb(stretch::assets::makeDummy());
  if (const stretch::Status written = stretch::writeFile(argv[1], glb); !written) {
    std::fprintf(stderr, "%s\n", written.error().line().c_str());
    return 1;
  }
  return 0;
}

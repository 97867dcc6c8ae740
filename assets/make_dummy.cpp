#include <cstdio>
#include <fstream>

#include "assets/dummy/dummy.h"

/// make-dummy OUT.glb: writes the bundled character.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make-dummy OUT.glb\n", stderr);
    return 2;
  }
  const std::vector<std::uint8_t> glb = stretch::assets::writeGlb(stretch::assets::makeDummy());
  std::ofstream file(argv[1], std::ios::binary);
  for (const std::uint8_t byte : glb) {
    file.put(static_cast<char>(byte));
  }
  file.close();
  if (!file) {
    std::fprintf(stderr, "%s: cannot be written; choose another path\n", argv[1]);
    return 1;
  }
  return 0;
}

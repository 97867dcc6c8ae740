#pragma once

#include <string>
#include <vector>

#include "assets/dummy/glb_writer.h"

namespace stretch::assets {

/// A file that comes with the program.
struct BundledFile {
  std::string name; ///< "dummy.glb"
  Character character;
};

/// All of them: the toon boxer with its one-two punch, the same with a baseball bat that it swings, and with
/// blocks that it leaps over.
[[nodiscard]] std::vector<BundledFile> bundledFiles();

} // namespace stretch::assets

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assets/dummy/motion.h"
#include "assets/dummy/skeleton.h"
#include "assets/dummy/skinned_mesh.h"

namespace stretch::assets {

struct Part {
  std::string name;
  double roughness = 0.6;
  SkinnedMesh mesh;
};

struct Character {
  std::vector<Joint> skeleton;
  std::vector<Part> parts; ///< Primitives of the one skinned mesh.
  std::vector<Motion> motions;
};

/// The character as GLB bytes. Every number is rounded to a coarse grid first, so that the last bits in which
/// the mathematical libraries of machines differ do not reach the file.
[[nodiscard]] std::vector<std::uint8_t> writeGlb(const Character& character);

} // namespace stretch::assets

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

/// A thing beside the character: a node of its own with a rigid mesh.
struct Prop {
  Part part;     ///< In the node's own space; the influences play no part.
  Vec3 position; ///< Of the node at rest.
};

struct Character {
  std::vector<Joint> skeleton;
  std::vector<Part> parts; ///< Primitives of the one skinned mesh.
  std::vector<Motion> motions;
  std::vector<Prop> props = {};
};

/// Index of a prop's node: after the joints, whose nodes have the joints' indices, and the skinned mesh.
[[nodiscard]] inline int propNode(const std::vector<Joint>& skeleton, std::size_t prop) {
  return static_cast<int>(skeleton.size() + 1 + prop);
}

/// The character as GLB bytes. Every number is rounded to a coarse grid first, so that the last bits in which
/// the mathematical libraries of machines differ do not reach the file.
[[nodiscard]] std::vector<std::uint8_t> writeGlb(const Character& character);

} // namespace stretch::assets

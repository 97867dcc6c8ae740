#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// Reads the texture coordinates of every set of a file that was loaded, not only of those that its materials
/// show.
class TextureSets {
public:
  explicit TextureSets(const Loaded& loaded);

  /// Texture coordinates of a primitive of Scene::meshes: TEXCOORD_0, TEXCOORD_1 ... as far as they follow
  /// each other, one pair for each vertex.
  [[nodiscard]] std::vector<std::vector<glm::vec2>> of(std::size_t mesh, std::size_t primitive) const;

private:
  std::shared_ptr<const Source> readable_; ///< With compressed parts decoded.
};

} // namespace stretch::gltf

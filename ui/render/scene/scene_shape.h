#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace stretch::ui {

/// Places of a primitive's vertices at one moment, in the space of its mesh: for meshes that move as
/// no skin and no morph target says.
struct PrimitiveShape {
  std::vector<glm::vec3> positions; ///< One for each vertex of the primitive.
  std::vector<glm::vec3> normals;   ///< One for each vertex.
  std::vector<glm::vec4> colors;    ///< Linear light; empty: they stay as they are.
};

/// One for each primitive of a scene, mesh by mesh.
using SceneShape = std::vector<PrimitiveShape>;

} // namespace stretch::ui

#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace stretch::ui {

/// Where the vertices of a primitive are at one moment, in the space of its mesh: for meshes that move as
/// no skin and no morph target says.
struct PrimitiveShape {
  std::vector<glm::vec3> positions; ///< As many as the primitive has.
  std::vector<glm::vec3> normals;   ///< The same number.
  std::vector<glm::vec4> colors;    ///< Linear light; empty: they stay as they are.
};

/// One for each primitive of a scene, mesh by mesh.
using SceneShape = std::vector<PrimitiveShape>;

} // namespace stretch::ui

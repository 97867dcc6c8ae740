#pragma once

#include <span>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/mesh_sequence.h"
#include "core/scene/scene.h"

namespace stretch::ui {

/// A triangle mesh as it lies in one frame of a sequence. The spans are read while the scene is made.
struct PlainMesh {
  std::span<const glm::vec3> positions; ///< World space.
  std::span<const Triangle> triangles;
  std::vector<glm::vec4> colors; ///< One for each vertex, linear light; or a single one for all.
};

/// A scene of meshes that stand where their vertices say, for the same renderer as characters. Normals are
/// those of the vertices' triangles, by area; both sides are drawn, since simulated surfaces are not always
/// closed.
[[nodiscard]] Scene sceneOfMeshes(std::span<const PlainMesh> meshes);

/// The only moment of such a scene.
[[nodiscard]] FrameState restOf(const Scene& scene);

} // namespace stretch::ui

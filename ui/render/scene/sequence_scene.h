#pragma once

#include <span>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/mesh_sequence.h"
#include "core/scene/scene.h"
#include "ui/render/scene/scene_shape.h"

namespace stretch::ui {

/// A triangle mesh as it lies in one frame of a sequence.
struct PlainMesh {
  std::vector<glm::vec3> positions;    ///< World space.
  std::span<const Triangle> triangles; ///< Read while the scene or the shape is made.
  std::vector<glm::vec4> colors;       ///< One for each vertex, linear light; or a single one for all.
};

/// A scene of meshes that stand where their vertices say, for the same renderer as characters. Normals are
/// those of the vertices' triangles, by area; both sides are drawn, since simulated surfaces are not always
/// closed.
[[nodiscard]] Scene sceneOfMeshes(std::span<const PlainMesh> meshes);

/// Returns the same meshes in another frame, as a shape of that scene; colours are taken from those that have
/// one for each vertex.
[[nodiscard]] SceneShape shapeOfMeshes(std::span<const PlainMesh> meshes);

/// The only moment of such a scene.
[[nodiscard]] FrameState restOf(const Scene& scene);

// Parts that scenes of frames are made of.

/// Adds the mesh, and a node that shows it where its vertices are.
void addMeshNode(Scene& scene, Mesh mesh);

/// A surface without a material of its own, seen from both sides.
[[nodiscard]] Material plainSurface(const glm::vec4& baseColor);

/// The grey of meshes that say nothing of their colour, linear light.
[[nodiscard]] glm::vec4 clayColor();

/// Twice the area of a triangle, along its normal.
[[nodiscard]] glm::vec3 triangleArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The direction of a sum of areas; upwards where there is none.
[[nodiscard]] glm::vec3 normalOfAreas(const glm::vec3& sum);

} // namespace stretch::ui

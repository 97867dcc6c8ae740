#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "ui/render/gl/gl_objects.h"
#include "ui/render/scene/scene_shape.h"

namespace stretch::ui {

/// Number of floats that the posing pass writes for each vertex: world position, world normal, (stretch
/// ratio, highlight).
inline constexpr std::size_t posedFloats = 8;

/// One primitive in the graphics card's memory, shared by every node that shows its mesh.
struct UploadedPart {
  int mesh = -1;
  std::size_t primitive = 0; ///< Counted through all meshes of the scene.
  int material = -1;
  int vertexCount = 0;
  int indexCount = 0;
  int influenceCount = 0; ///< Largest number of influences that a vertex uses; 0 when not skinned.
  bool hasTexCoords = false;
  bool hasColors = false;
  GlBuffer shape;      ///< Position and normal, interleaved; rewritten when morph weights or shapes change.
  GlBuffer influences; ///< VertexInfluences as they are in memory.
  GlBuffer surface;    ///< Texture coordinates and colour, interleaved.
  GlBuffer indices;
  // For morphing on the CPU; empty without targets.
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<MorphTarget> targets;
  std::vector<float> shapeWeights; ///< Morph weights that `shape` holds.
};

/// One primitive as one node shows it, with room for its posed vertices.
struct DrawItem {
  std::size_t part = 0;
  NodeIndex node;
  int skin = -1; ///< -1: hangs rigidly on the node.
  GlVertexArray poseInput;
  GlBuffer posed;        ///< posedFloats for each vertex, world space.
  GlVertexArray surface; ///< Draws the posed vertices.
};

/// A scene in the graphics card's memory.
struct UploadedScene {
  std::vector<UploadedPart> parts;
  std::vector<DrawItem> items; ///< Items of nodes below the roots, in the file's order.
  std::shared_ptr<const std::vector<GlTexture>> textures; ///< One for each image; empty for images without
                                                          ///< pixels or beyond the driver's limit.
};

/// Uploads what the default scene shows. Indices that point outside are a broken invariant of the reader;
/// primitives without vertices or triangles are left out.
[[nodiscard]] UploadedScene uploadScene(const Scene& scene);
/// Uploads other meshes in the places of the scene's; they look at the textures of an upload of it.
[[nodiscard]] UploadedScene uploadMeshes(const Scene& scene, const std::vector<Mesh>& meshes,
                                         std::shared_ptr<const std::vector<GlTexture>> textures);

/// Makes `shape` hold the mesh at these morph weights (missing ones count as 0).
void morph(UploadedPart& part, const std::vector<float>& weights);

/// Makes the vertices stand where the shape says. `scene` is what was uploaded; the shape has to fit it.
void reshape(UploadedScene& uploaded, const Scene& scene, const SceneShape& shape);

} // namespace stretch::ui

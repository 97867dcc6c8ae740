#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/gltf/import/mesh_surface.h"
#include "core/scene/mesh_sequence.h"
#include "core/scene/scene.h"
#include "ui/render/scene/scene_shape.h"

namespace stretch::ui {

/// A mesh sequence with the materials, textures and colours of its source, for the renderer of characters.
/// What stays over the frames is made once; a frame is a shape of it.
class SequenceSurface {
public:
  /// The sequence has at least one frame.
  explicit SequenceSurface(const MeshSequence& sequence);

  /// The first frame. What the source gives no material for is one calm grey, seen from both sides.
  [[nodiscard]] Scene scene() const;

  /// `places`: one position for each vertex of the sequence. A normal of the source turns with the triangles
  /// around its vertex; without any, normals are those of the triangles, by area.
  [[nodiscard]] SceneShape shapeAt(std::span<const glm::vec3> places) const;

private:
  /// A primitive by its vertices of the surface.
  struct Part {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> indices; ///< Into `vertices`, three for each triangle.
    int material = -1;
  };

  [[nodiscard]] Part partOf(const gltf::SurfacePart& triangles) const;
  [[nodiscard]] std::vector<glm::vec3> smoothNormals(std::span<const glm::vec3> places) const;
  [[nodiscard]] std::vector<glm::vec3> normalsAt(std::span<const glm::vec3> places) const;
  [[nodiscard]] PrimitiveShape shapeOf(const Part& part, std::span<const glm::vec3> places,
                                       const std::vector<glm::vec3>& normals) const;
  void addLook(Primitive& primitive, const Part& part, std::size_t baseColorSet,
               std::size_t emissiveSet) const;

  std::shared_ptr<const gltf::MeshSurface> surface_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> smoothed_;   ///< For each vertex of the surface the group whose triangles it is
                                          ///< smooth with.
  std::vector<glm::vec3> firstNormals_;   ///< Normals of the groups, in the first frame.
  std::vector<glm::vec3> firstPositions_; ///< Places of the sequence's vertices, in the first frame.
};

} // namespace stretch::ui

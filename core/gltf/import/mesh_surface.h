#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/scene/mesh_sequence.h"

namespace stretch::gltf {

struct Source;

/// Triangles in a row that share a material.
struct SurfacePart {
  std::string name;  ///< Name of the mesh or group; may be empty.
  int material = -1; ///< Index into the materials; -1: none.
  std::size_t firstTriangle = 0;
  std::size_t triangleCount = 0;
};

/// Looks of a sequence's mesh, beyond its vertices' places. A file splits vertices along seams
/// of a texture and along hard edges: the sequence moves each place once, the surface has the vertices of the
/// file, several at one place.
struct MeshSurface {
  std::vector<std::uint32_t> places; ///< For each vertex of the surface the vertex of the sequence.
  std::vector<glm::vec3> normals;    ///< Normals of the first frame, unit length; empty where the file gives
                                     ///< none.
  std::vector<std::vector<glm::vec2>> texCoords; ///< Set by set (TEXCOORD_0 ...), as glTF counts: v
                                                 ///< downwards.
  std::vector<glm::vec4> colors;                 ///< COLOR_0, linear; empty when there are none.
  std::vector<Triangle> triangles; ///< By vertices of the surface, in the order of the sequence's triangles.
  std::vector<SurfacePart> parts;  ///< Cover all triangles, in their order.
  std::shared_ptr<const Source> materials; ///< See materialsOf (core/gltf/import/material_library.h); may be
                                           ///< null.
};

} // namespace stretch::gltf

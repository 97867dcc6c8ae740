#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/file.h"
#include "core/base/result.h"
#include "core/gltf/import/accessor.h"

namespace stretch::gltf {

/// An attribute of a Draco mesh and the form in which it is wanted.
struct DracoAttribute {
  std::uint32_t id = 0; ///< The unique id that the Draco data give it.
  int width = 1;        ///< Components for each vertex.
  ComponentType component = ComponentType::float32;
};

/// Mesh of KHR_draco_mesh_compression, decoded.
struct DracoMesh {
  std::size_t vertexCount = 0;
  std::vector<std::uint32_t> corners; ///< Three vertices for each triangle.
  std::vector<Bytes> attributes;      ///< In the order and form asked for, tightly packed.
};

/// Error, without a place: no Draco mesh of the version that glTF uses (2.2), counts that the bytes cannot
/// hold or that would take more than `mostBytes` of memory (told before it is taken), an attribute that is
/// not there or of another width, bytes that do not decode.
[[nodiscard]] Result<DracoMesh> decodeDraco(std::span<const std::uint8_t> bytes,
                                            std::span<const DracoAttribute> wanted, std::size_t mostBytes);

} // namespace stretch::gltf

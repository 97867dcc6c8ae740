#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/gltf/json/json_document.h"

namespace stretch::interchange {

/// A binary glTF file put together piece by piece: entries of its lists, and accessors over bytes of one
/// buffer.
class GlbParts {
public:
  GlbParts();

  /// Index of the entry in the list of that name ("nodes").
  std::size_t add(const char* list, const gltf::Json& entry);

  /// Index of an accessor: values of "SCALAR", "VEC3", "MAT4" and so on; with the least and greatest of each
  /// where the specification asks for them. The same times are written once.
  std::size_t addFloats(const std::vector<float>& values, const std::string& type, bool withBounds = false);
  /// Joints of vertices: four in a row each.
  std::size_t addJoints(const std::vector<std::uint16_t>& joints);
  std::size_t addIndices(const std::vector<std::uint32_t>& indices);
  /// Index of a view over bytes that no accessor reads: a picture.
  std::size_t addBytes(std::span<const std::uint8_t> bytes);

  /// The whole file. The lists of it that are named here are its roots and clips; empty lists are left out.
  [[nodiscard]] Result<Bytes> finish();

private:
  std::size_t addAccessor(std::span<const std::uint8_t> bytes, gltf::Json accessor);

  gltf::JsonDocument json_;
  Bytes bytes_;
  std::map<std::vector<float>, std::size_t> times_;
};

} // namespace stretch::interchange

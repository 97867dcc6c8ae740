#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/file.h"
#include "core/base/result.h"

namespace stretch::gltf {

/// A buffer view as EXT_meshopt_compression describes it: `bytes` decode to `count` elements of `stride`
/// bytes.
struct MeshoptView {
  std::span<const std::uint8_t> bytes;
  std::uint64_t count = 0;
  std::uint64_t stride = 0;
  std::string mode;            ///< ATTRIBUTES, TRIANGLES or INDICES.
  std::string filter = "NONE"; ///< NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL.
};

/// The elements. Error, without a place: a mode, filter or stride that the extension does not know, more
/// elements than the bytes can hold (told before any memory is taken), bytes that do not decode.
[[nodiscard]] Result<Bytes> decodeMeshopt(const MeshoptView& view);

} // namespace stretch::gltf

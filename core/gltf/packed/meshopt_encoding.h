#pragma once

#include <cstddef>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// The source with the views of its first buffer compressed (EXT_meshopt_compression, then required); those
/// that no accessor reads, as images, and those whose elements the extension cannot hold are copied as they
/// are. Made for sources of one buffer, in which each accessor has a view of its own.
[[nodiscard]] Source withMeshopt(const Source& source);

/// Bytes that an accessor's view takes in the file, compressed or not.
[[nodiscard]] std::size_t storedBytes(const Json& json, std::size_t accessor);

} // namespace stretch::gltf

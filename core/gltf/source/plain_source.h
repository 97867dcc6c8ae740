#pragma once

#include <optional>
#include <set>

#include "core/gltf/source/problems.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// A file with its compressed parts (EXT_meshopt_compression, KHR_draco_mesh_compression) decoded into
/// buffers of their own behind the file's, and with buffer views and accessors that point there. For reading
/// only: what is saved is the source, whose compressed data stay as they are. Everything keeps its index, so
/// that messages name places of the file; what is new stands at the ends.
struct PlainSource {
  Source source;
  std::set<std::size_t> roundedAccessors; ///< Accessors whose values the codec rounds: their min and max are
                                          ///< the originals'.
  std::size_t packedBytes = 0;            ///< Size of the file's own buffers.
  std::size_t decodedBytes = 0;
};

/// Nothing when no part of the file is compressed. The structure has to be validated, the buffers read. Data
/// that cannot be decoded are an error that names their place; the answer is then not to be used.
[[nodiscard]] std::optional<PlainSource> plainSource(const Source& source, Problems& problems);

/// Opens buffer views alone; meshes that are compressed as a whole stay closed: enough for what no
/// mesh holds.
[[nodiscard]] std::optional<PlainSource> withPlainViews(const Source& source, Problems& problems);

/// Whether the buffer only stands in for compressed data: it may be without bytes, and nothing else may lie
/// in it.
[[nodiscard]] bool isFallbackBuffer(const Json& buffer);

} // namespace stretch::gltf

#pragma once

#include <span>

#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/plain_source.h"

namespace stretch::gltf {

// Parts of plainSource.

/// Decodes the buffer views that are compressed.
void openViews(PlainSource& plain, Problems& problems);

/// Decodes the primitives that are compressed as a whole; their views have to be plain.
void openMeshes(PlainSource& plain, Problems& problems);

[[nodiscard]] bool hasCompressedViews(const Json& json);
[[nodiscard]] bool hasCompressedMeshes(const Json& json);

/// Adds the bytes as a buffer; answers its index.
std::size_t addPlainBuffer(PlainSource& plain, Bytes bytes);

/// Bytes that may still be decoded, all parts of a file together.
[[nodiscard]] std::size_t bytesLeftToDecode(const PlainSource& plain);

/// The bytes that "buffer", "byteOffset" and "byteLength" of an object name; nothing when they are not there.
[[nodiscard]] std::optional<std::span<const std::uint8_t>> namedBytes(const Source& source,
                                                                      const Json& object);

} // namespace stretch::gltf

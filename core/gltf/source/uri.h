#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/gltf/source/glb.h"

namespace stretch::gltf {

[[nodiscard]] bool isDataUri(std::string_view uri);

/// "data:<media type>;base64,<content>"
struct DataUri {
  std::string mediaType; ///< May be empty.
  Bytes bytes;
};

/// In base64 or written out. Nothing for a URI that is malformed.
[[nodiscard]] std::optional<DataUri> decodeDataUri(std::string_view uri);

[[nodiscard]] std::string encodeBase64(std::span<const std::uint8_t> bytes);

/// The path that a relative URI stands for, %-escapes decoded. Nothing for URIs with a scheme, absolute paths
/// and names that no file can have.
[[nodiscard]] std::optional<std::filesystem::path> relativePath(std::string_view uri);

/// A file name as a URI: what has a meaning there is %-escaped.
[[nodiscard]] std::string percentEncoded(std::string_view name);

/// Whether a relative path leaves the folder that it starts in.
[[nodiscard]] bool escapesFolder(const std::filesystem::path& relative);

} // namespace stretch::gltf

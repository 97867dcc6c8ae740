#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"

namespace stretch::interchange {

/// Format of another program that is made into glTF (docs/import_clip.md, Other formats).
enum class Format { fbx, bvh, collada };

/// The name that people know it by: "FBX".
[[nodiscard]] std::string nameOf(Format format);

/// Told by the first bytes, whatever the file is called. Nothing for everything else, glTF among it.
[[nodiscard]] std::optional<Format> formatOf(std::span<const std::uint8_t> bytes);

/// Error for bytes that are neither glTF nor made into it: the kind of file that they are and the way out,
/// for about thirty kinds that are taken for a character (archives, pictures, scenes of other programs,
/// meshes, texts). Nothing for what may be the text of a glTF, and for an empty file.
[[nodiscard]] std::optional<Error> otherKind(std::span<const std::uint8_t> bytes);

/// Whether a file of this name is one of another program, by its extension: for what is shown before it is
/// read.
[[nodiscard]] bool isForeignName(const std::string& extension);

} // namespace stretch::interchange

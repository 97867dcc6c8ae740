#pragma once

#include <string>
#include <string_view>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// Parses the JSON of a glTF file. Refused with the place: a byte order mark, more than 256 levels of
/// nesting, numbers out of range, invalid UTF-8, anything that is no object.
[[nodiscard]] Result<Json> parseJson(std::string_view text);

/// Any other JSON that a file holds: recipes, settings, tables. Discarded for what is none, and for more than
/// 256 levels of nesting, which would overflow the stack of whoever walks through it.
[[nodiscard]] Json parseAnyJson(std::string_view text);

/// Parses JSON that people write by hand, where a key that stands twice in one object is a mistake: an error
/// with its place. Text that is no JSON is an error with this remedy.
[[nodiscard]] Result<Json> parseHandwrittenJson(std::string_view text, const std::string& remedy);

} // namespace stretch::gltf

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/gltf/json/json.h"

namespace stretch::gltf {

/// Room for `count` members. The map of the library grows by copying all it holds, since its keys cannot be
/// moved; this moves the values, so that a tree is not copied with every key that stands beside it.
void reserveMembers(Json::object_t& object, std::size_t count);

/// JSON text as a tree, as Json::parse makes it: of two members with one key the first place and the last
/// value. Much faster for trees whose objects hold long lists. The text must be nested no deeper than the
/// caller can bear.
struct JsonFailure {
  std::size_t byte = 0;      ///< Place of the error, 1-based.
  bool isOutOfRange = false; ///< A number that double precision cannot hold; else no valid JSON.
};
[[nodiscard]] std::optional<JsonFailure> buildJson(std::string_view text, Json& tree);

/// Place of the first key that an object of this JSON text has twice: "trails[0].scale". Nothing where there
/// is none, or no valid JSON before one.
[[nodiscard]] std::optional<std::string> repeatedKey(std::string_view text);

} // namespace stretch::gltf

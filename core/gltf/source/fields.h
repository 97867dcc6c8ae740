#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

inline constexpr double largestWhole = 9007199254740992.0; ///< 2^53: to here a JSON number is exact.

// Reading of JSON that may hold anything: a missing property and one of another type answer the same, never
// an exception.

/// The property, or null when `object` is no object or has none of that name.
[[nodiscard]] const Json* find(const Json& object, std::string_view key);

/// Finds a value along a path of names, as above.
[[nodiscard]] const Json* findPath(const Json& object, std::initializer_list<std::string_view> keys);

/// A whole number that is not negative: 3 as well as 3.0, up to 2^53.
[[nodiscard]] std::optional<std::uint64_t> wholeNumber(const Json& value);

[[nodiscard]] std::uint64_t wholeOr(const Json& object, std::string_view key, std::uint64_t fallback);
[[nodiscard]] int indexOr(const Json& object, std::string_view key, int fallback = -1);
[[nodiscard]] double numberOr(const Json& object, std::string_view key, double fallback);
[[nodiscard]] std::string textOr(const Json& object, std::string_view key, std::string_view fallback = "");
/// The object's name in one line: spaces stand for characters that break a line or steer a terminal.
[[nodiscard]] std::string shownName(const Json& object);
[[nodiscard]] bool flagOr(const Json& object, std::string_view key, bool fallback);

/// The numbers of an array property; empty when it is missing or holds anything else.
[[nodiscard]] std::vector<double> numbersOf(const Json& object, std::string_view key);

/// Indices of an array property; empty when it is missing or holds anything else.
[[nodiscard]] std::vector<int> indicesOf(const Json& object, std::string_view key);

/// Elements of an array property: 0 when it is missing or no array.
[[nodiscard]] std::size_t sizeOf(const Json& object, std::string_view key);

/// Element of the array property; has to be there.
[[nodiscard]] const Json& element(const Json& object, std::string_view key, std::size_t index);

/// Whether an array property of texts holds `text` ("extensionsUsed").
[[nodiscard]] bool listsText(const Json& object, std::string_view key, std::string_view text);

} // namespace stretch::gltf

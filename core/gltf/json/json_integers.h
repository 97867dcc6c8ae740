#pragma once

#include <vector>

#include "core/gltf/json/json_document.h"

namespace stretch::gltf {

/// The integer that a value is. Throws the library's type error, as its own readers do, for anything
/// else, a fraction and a number beyond `int` included: those the library would cut or leave undefined.
[[nodiscard]] int integerOf(const Json& value);

/// Integers of a list, by the same rules.
[[nodiscard]] std::vector<int> integersOf(const Json& list);

} // namespace stretch::gltf

#pragma once

#include <vector>

#include "app/selection_set.h"
#include "core/base/result.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

/// Selection sets as a list: "name", and "limbs" or "controllers".
[[nodiscard]] gltf::Json selectionSetsToJson(const std::vector<SelectionSet>& sets);

/// Reads what selectionSetsToJson writes. A set without a name or with that of another one, without members
/// or with members of both kinds, and an unknown key are errors.
[[nodiscard]] Result<std::vector<SelectionSet>> selectionSetsFromJson(const gltf::Json& json);

} // namespace stretch::app

#pragma once

#include "app/schema/schema.h"
#include "rig/styles/style.h"

namespace stretch::app {

/// All settings of a style but its name and origin. Options begin with "--style-".
[[nodiscard]] const Schema<rig::Style>& styleSchema();

/// A style as a file holds it: "version", "name" and every setting of the schema.
[[nodiscard]] gltf::Json styleToJson(const rig::Style& style);

/// Reads what styleToJson writes, as a style of the user's own; what is missing is as in a new style. An
/// unknown key, a wrong value, a range whose numbers do not rise and a missing name are errors that name the
/// key.
[[nodiscard]] Result<rig::Style> styleFromJson(const gltf::Json& json);

/// Refuses a style whose numbers contradict each other: least, usual and most of a kind rise, and both eases
/// leave room for each other.
[[nodiscard]] Status checkStyle(const rig::Style& style);

} // namespace stretch::app

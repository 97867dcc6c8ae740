#pragma once

#include "app/schema/schema.h"
#include "app/weight/weight_settings.h"

namespace stretch::app {

/// All settings of a limb's weight but range and moduli, which have shapes of their own.
[[nodiscard]] const Schema<WeightSettings>& weightSchema();

/// Settings as recipes and saved files hold them: every setting of the schema, "range" where it is not the
/// whole clip, "moduli" where a bone has its own.
[[nodiscard]] gltf::Json weightToJson(const WeightSettings& settings);

/// Reads what weightToJson writes; what is missing keeps its value in `settings`. `allowed` names further
/// keys that the caller reads itself. An unknown key or a wrong value is an error that names it.
[[nodiscard]] Status weightFromJson(const gltf::Json& json, const std::vector<std::string>& allowed,
                                    WeightSettings& settings);

} // namespace stretch::app

#pragma once

#include <string>
#include <vector>

#include "app/schema/adjustment_json.h"
#include "app/schema/schema.h"
#include "rig/hold/hold.h"

namespace stretch::app {

// Pins, grips and props as text: everything but the clip. The readers read what the writers write; a key of
// the wrong kind and an unknown one are errors that name it. `allowed` names further keys that the caller
// reads itself.

[[nodiscard]] gltf::Json pinToJson(const rig::Pin& pin, const AdjustmentUnits& units);
[[nodiscard]] Result<rig::Pin> pinFromJson(const gltf::Json& json, const AdjustmentUnits& units,
                                           const std::vector<std::string>& allowed);

[[nodiscard]] gltf::Json gripToJson(const rig::Grip& grip);
[[nodiscard]] Result<rig::Grip> gripFromJson(const gltf::Json& json, const std::vector<std::string>& allowed);

[[nodiscard]] gltf::Json propToJson(const rig::Prop& prop, const AdjustmentUnits& units);
[[nodiscard]] Result<rig::Prop> propFromJson(const gltf::Json& json, const AdjustmentUnits& units,
                                             const std::vector<std::string>& allowed);

} // namespace stretch::app

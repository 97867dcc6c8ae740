#pragma once

#include "app/schema/schema.h"
#include "core/gltf/json/json.h"

namespace stretch::test {

/// A value of the setting that is not its default.
[[nodiscard]] gltf::Json otherValue(const app::SettingFacts& setting);

} // namespace stretch::test

#pragma once

#include <filesystem>

#include "app/schema/schema.h"
#include "rig/body/locators/locators.h"

namespace stretch::app {

// Locators as text (docs/from_a_mesh.md, Locators): {"plan": "biped", "locators": [{"name": "leftUpperArm",
// "position": [x, y, z], "orientation": [x, y, z, w], "confidence": 0.9}]}, in the scene's units and axes.

[[nodiscard]] gltf::Json locatorsToJson(const rig::Locators& locators);

/// Reads what locatorsToJson writes, in any order. "plan" and "confidence" may be missing; where no locator
/// has an orientation, all are turned along their bones. Error, which names the locator: a name that the plan
/// does not have or that comes twice, a joint that the plan needs and that is missing, anything that is no
/// place or turn, two joints of one bone in one place.
[[nodiscard]] Result<rig::Locators> locatorsFromJson(const gltf::Json& json);

/// Reads locators from a file.
[[nodiscard]] Result<rig::Locators> loadLocators(const std::filesystem::path& path);

} // namespace stretch::app

#pragma once

#include <optional>
#include <string>

#include "app/locators/fit_locators.h"
#include "rig/body/locators/locator_plans.h"

namespace stretch::app {

/// Locators of a plan other than the biped's, fitted to meshes. Error, one line: a mesh that shows no body,
/// or fewer pairs of legs than the plan has.
[[nodiscard]] Result<FittedLocators> ofCreature(const MeshesInWorld& meshes, const rig::LocatorPlan& plan,
                                                const skinning::Proceed& proceed);

/// Locators of what stands on four legs or more as its scene has it; nothing where nothing does.
[[nodiscard]] std::optional<FittedLocators> standingOnManyLegs(const MeshesInWorld& meshes,
                                                               const skinning::Proceed& proceed);

/// Locators of the plan that the meshes show by the legs that they stand on and by a trunk that lies.
/// `doubt`: why they are no biped. Error, one line, that names the option: no plan shows clearly.
[[nodiscard]] Result<FittedLocators> ofShownPlan(const MeshesInWorld& meshes, const std::string& doubt,
                                                 const skinning::Proceed& proceed);

} // namespace stretch::app

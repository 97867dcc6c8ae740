#pragma once

#include <string>

#include "app/document.h"

namespace stretch::app {

/// Puts a limb corrected by hand in the place of the one of its kind, or adds it where none was found. Trails
/// of the limb stay and follow the corrected joints.
[[nodiscard]] Result<Document> correctLimb(const Document& document, rig::Limb limb);

/// Reads the body as one of another plan (rig/plan/body_plan.h). What was set up for limbs that it has no
/// more goes with them.
[[nodiscard]] Result<Document> changePlan(const Document& document, const std::string& plan);

/// Forgets corrections made by hand and looks for the plan and its limbs anew. What was set up for limbs that
/// are gone goes with them.
[[nodiscard]] Document detectLimbsAgain(const Document& document);

/// Adds a chain that the user picked; the same chain twice is refused.
[[nodiscard]] Result<Document> addChain(const Document& document, rig::Limb chain);

} // namespace stretch::app

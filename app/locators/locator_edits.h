#pragma once

#include <string>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// Whether locators are shown and can be moved: the document has some, and no joints stand at them, or they
/// are to be shown even so.
[[nodiscard]] bool showsLocators(const Document& document, bool evenAtJoints);

/// Moves locators by a vector of the world; they are then sure. `mirror`: the counterpart of each on the
/// other side, where it is not among them, moves as its mirror image, and what is in the middle stays there.
/// Bones that begin or end there take their turns along. Names that have no locator are left out.
[[nodiscard]] Document moveLocators(const Document& document, const std::vector<std::string>& names,
                                    const Vec3& change, bool mirror);

/// Turns locators about their places by a rotation vector of the world, counterparts the other way.
[[nodiscard]] Document turnLocators(const Document& document, const std::vector<std::string>& names,
                                    const Vec3& rotationVector, bool mirror);

/// Moves locators across their bones to the middle of the mesh there; those outside of it stay.
[[nodiscard]] Document snapLocators(const Document& document, const std::vector<std::string>& names,
                                    bool mirror);

} // namespace stretch::app

#pragma once

#include "app/edits/trail/place_trails.h"
#include "app/recipe/recipe.h"

namespace stretch::app {

/// Adds the adjustments of a recipe, its trails, exaggerated and connected, and the weight of limbs: what the
/// command line, the editor and pictures make of a recipe. All of it or nothing; trails and adjustments that
/// are in the way give way.
[[nodiscard]] Result<PlacedTrails> withRecipe(const Document& document, const Recipe& recipe);

} // namespace stretch::app

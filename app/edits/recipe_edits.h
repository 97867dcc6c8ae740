#pragma once

#include "app/document.h"
#include "app/recipe/recipe.h"

namespace stretch::app {

/// Adds the trails of a recipe, exaggerated and connected. Refused as a whole when one of them overlaps a
/// trail that is there.
[[nodiscard]] Result<Document> withRecipe(const Document& document, const Recipe& recipe);

} // namespace stretch::app

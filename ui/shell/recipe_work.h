#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

/// Writes the viewed clip's trails as a recipe.
void saveRecipeFile(Shell& shell, const std::filesystem::path& path);
/// Replays a recipe on this character, as one undo step.
void loadRecipeFile(Shell& shell, const std::filesystem::path& path);

} // namespace stretch::ui

#include "ui/shell/recipe_work.h"

#include <fmt/format.h>

#include "app/edits/recipe_edits.h"
#include "app/recipe/recipe.h"
#include "core/gltf/json.h"

namespace stretch::ui {

void saveRecipeFile(Shell& shell, const std::filesystem::path& path) {
  const gltf::Json json =
      app::recipeToJson(shell.open.character()->document(), shell.open.character()->view().clip);
  const Status done = writeText(path, json.dump(2, ' ', false, gltf::Json::error_handler_t::replace) + "\n");
  tellProblem(shell, done);
  if (done) {
    tell(shell, ToastKind::success, "Saved the recipe " + path.filename().string());
  }
}

void loadRecipeFile(Shell& shell, const std::filesystem::path& path) {
  app::Document document = shell.open.character()->document();
  const Result<app::Recipe> recipe = app::loadRecipe(path, document);
  if (!recipe) {
    tell(shell, ToastKind::error, recipe.error().line());
    return;
  }
  Result<app::Document> changed = app::withRecipe(document, *recipe);
  if (!changed) {
    tell(shell, ToastKind::error, changed.error().line());
    return;
  }
  shell.open.character()->edit(std::move(changed).value(), "Replay a recipe");
  shell.open.character()->view().clip = recipe->clip;
  tell(shell, ToastKind::success, fmt::format("{} trails from the recipe", recipe->trails.size()));
}

} // namespace stretch::ui

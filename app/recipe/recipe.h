#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/things/thing.h"

namespace stretch::app {

/// A recipe (docs/recipes.md): an edit that can be replayed on another clip or character.
struct Recipe : Things { // Trails have no ids; limbs exist in the document.
  int clip = 0;
  bool loops = false;  ///< The clip is marked as a loop.
  Reference reference; ///< Without images and sound where the recipe has none.
};

/// Reads a recipe for a document: names its clip and limbs (chains are added to the document), turns
/// fractions of the clip into frames and offsets in lengths of the limb into world units. Ranges that are
/// left out get the default range. An unknown key or a value of the wrong kind is an error that names it.
/// `clip`: plays on this one instead of the clip that the recipe names.
/// `folder`: where the files of props are looked for; they are added to the document.
[[nodiscard]] Result<Recipe> recipeFromJson(const gltf::Json& json, Document& document,
                                            std::optional<int> clip = {},
                                            const std::filesystem::path& folder = {});
[[nodiscard]] Result<Recipe> loadRecipe(const std::filesystem::path& path, Document& document,
                                        std::optional<int> clip = {});

/// The adjustments, the trails, the holds and the weight of limbs of one clip as a recipe.
[[nodiscard]] gltf::Json recipeToJson(const Document& document, int clip);

} // namespace stretch::app

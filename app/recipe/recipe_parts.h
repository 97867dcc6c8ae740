#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/document.h"
#include "app/recipe/recipe.h"
#include "app/schema/adjustment_json.h"
#include "core/gltf/json/json.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

// For the sources that read and write parts of a recipe.

/// Document and clip that a part of a recipe is read for.
struct RecipeGround {
  const Document& document;
  int clip = 0;
  bool inMetres = false;
  double lastFrame = 0.0; ///< Last frame of the clip, counted as the recipe counts.
};

/// Lengths in those of the controller's limb, or in world units; angles in degrees.
[[nodiscard]] AdjustmentUnits unitsOf(double limbLength, bool inMetres);

/// An entry whose frames may be given as fractions of the clip: each key that ends with "_of_clip" becomes
/// the one without that ending, whatever stands there. An error for what is no fraction.
[[nodiscard]] Result<gltf::Json> withFrames(const gltf::Json& entry, double lastFrame);

/// Every entry of a list that may be left out, each made by `make`. Errors name list and entry.
template <typename Entry, typename Make>
[[nodiscard]] Status readList(const gltf::Json& recipe, const char* list, const RecipeGround& ground,
                              std::vector<Entry>& entries, Make&& make) {
  const gltf::Json items = recipe.value(list, gltf::Json::array());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Result<gltf::Json> inFrames = withFrames(items[i], ground.lastFrame);
    Result<Entry> entry = inFrames ? make(*inFrames) : Result<Entry>(inFrames.error());
    if (!entry) {
      const std::string where = fmt::format("{}[{}]", list, i);
      const Error& error = entry.error();
      return Error{error.what, error.where.empty() ? where : where + "." + error.where, error.remedy};
    }
    entries.push_back(std::move(*entry));
  }
  return Success{};
}

/// The lists "pins", "grips" and "props" of a recipe.
[[nodiscard]] Result<rig::Holds> holdsFromRecipe(const gltf::Json& recipe, const RecipeGround& ground);
void addHoldsToRecipe(const Document& document, int clip, gltf::Json& recipe);

/// Adds the files that props of the recipe name to the document, where its adjustments have the hands, and
/// names their nodes in the recipe that was read from it. What an earlier replay has added is taken again.
[[nodiscard]] Status addPropFiles(const gltf::Json& json, bool inMetres, const std::filesystem::path& folder,
                                  Recipe& recipe, Document& document);

/// The entry of a prop, by the file that its node was added with, where it was.
[[nodiscard]] gltf::Json withFileOfProp(const Document& document, const rig::Prop& prop, gltf::Json entry);

/// Unit of a recipe's lengths of props and of the body.
[[nodiscard]] double lengthOfBody(const Document& document);

} // namespace stretch::app

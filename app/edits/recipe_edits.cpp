#include "app/edits/recipe_edits.h"

#include "app/edits/trail_edits.h"
#include "app/edits/weight_edits.h"

namespace stretch::app {

Result<Document> withRecipe(const Document& document, const Recipe& recipe) {
  Document changed = document;
  for (const rig::Trail& wanted : recipe.trails) {
    Result<CreatedTrail> created =
        createTrail(changed, {wanted.limb, recipe.clip, wanted.settings, true, true});
    if (!created) {
      return created.error();
    }
    changed = std::move(created->document);
    rig::Trail& trail = *findTrail(changed, created->trailId);
    trail.colour = wanted.colour;
    trail.controlFrames = wanted.controlFrames;
  }
  for (const WeightedLimb& wanted : recipe.weights) {
    Result<Document> next = setWeight(changed, wanted);
    if (!next) {
      return next.error();
    }
    changed = std::move(*next);
  }
  return changed;
}

} // namespace stretch::app

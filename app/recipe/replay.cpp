#include "app/recipe/replay.h"

#include "app/edits/trail/group_edits.h"
#include "app/reference/reference_edits.h"

namespace stretch::app {

Result<PlacedTrails> withRecipe(const Document& document, const Recipe& recipe) {
  Things things = static_cast<const Things&>(recipe);
  const int othersGroups = freeGroup(document) - 1;
  for (rig::Trail& trail : things.trails) {
    trail.group += trail.group > 0 ? othersGroups : 0;
    trail.exaggerated = true;
    trail.connected = true;
  }
  const Reference none{.clip = recipe.clip};
  const bool refers = recipe.reference.images != none.images || recipe.reference.sound != none.sound;
  return place(refers ? withReference(document, recipe.reference) : document, things, Entry::request);
}

} // namespace stretch::app

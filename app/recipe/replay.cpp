#include "app/recipe/replay.h"

#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
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
  Reference reference = referenceOf(document, recipe.clip);
  reference.images = recipe.reference.images.file.empty() ? reference.images : recipe.reference.images;
  reference.sound = recipe.reference.sound.file.empty() ? reference.sound : recipe.reference.sound;
  const Document changed = recipe.loops ? setLooping(document, recipe.clip, true) : document;
  return place(withReference(changed, reference), things, Entry::request);
}

} // namespace stretch::app

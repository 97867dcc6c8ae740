#include "app/recipe/replay.h"

#include "app/edits/trail/group_edits.h"

namespace stretch::app {

Result<PlacedTrails> withRecipe(const Document& document, const Recipe& recipe) {
  Things things = static_cast<const Things&>(recipe);
  const int othersGroups = freeGroup(document) - 1;
  for (rig::Trail& trail : things.trails) {
    trail.group += trail.group > 0 ? othersGroups : 0;
    trail.exaggerated = true;
    trail.connected = true;
  }
  return place(document, things, Entry::request);
}

} // namespace stretch::app

#include "app/recipe/replay.h"

#include <utility>

#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/weight_edits.h"

namespace stretch::app {

Result<PlacedTrails> withRecipe(const Document& document, const Recipe& recipe) {
  std::vector<rig::Trail> trails = recipe.trails;
  const int othersGroups = freeGroup(document) - 1;
  for (rig::Trail& trail : trails) {
    trail.group += trail.group > 0 ? othersGroups : 0;
    trail.exaggerated = true;
    trail.connected = true;
  }
  Result<PlacedTrails> placed = placeTrails(document, trails, Entry::request);
  if (!placed) {
    return placed;
  }
  if (Result<Document> adjusted = placeAdjustments(placed->document, recipe.adjustments); adjusted) {
    placed->document = std::move(*adjusted);
  } else {
    return adjusted.error();
  }
  if (Result<Document> held = placeHolds(placed->document, recipe.holds); held) {
    placed->document = std::move(*held);
  } else {
    return held.error();
  }
  for (const WeightedLimb& wanted : recipe.weights) {
    Result<Document> next = setWeight(placed->document, wanted);
    if (!next) {
      return next.error();
    }
    placed->document = std::move(*next);
  }
  return placed;
}

} // namespace stretch::app

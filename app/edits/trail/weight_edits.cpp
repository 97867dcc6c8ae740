#include "app/edits/trail/weight_edits.h"

#include <algorithm>

#include "app/edits/trail/starting_settings.h"
#include "app/things/place.h"

namespace stretch::app {

Result<Document> setWeight(const Document& document, const WeightedLimb& wanted) {
  return documentOf(placeOf<WeightedLimb>(document, {wanted}, Entry::request));
}

Document removeWeight(const Document& document, const std::string& limb, int clip) {
  Document changed = document;
  std::erase_if(changed.weights,
                [&](const WeightedLimb& entry) { return entry.limb == limb && entry.clip == clip; });
  return changed;
}

Result<Document> switchWeight(const Document& document, const std::vector<std::string>& limbs, int clip,
                              bool on) {
  Document changed = document;
  for (const std::string& limb : limbs) {
    const WeightedLimb* const present = findWeight(changed, limb, clip);
    if (present == nullptr && !on) {
      continue;
    }
    WeightedLimb entry =
        present != nullptr ? *present : WeightedLimb{limb, clip, true, usualWeight(document, limb)};
    entry.on = on;
    Result<Document> next = setWeight(changed, entry);
    if (!next) {
      return next.error();
    }
    changed = std::move(*next);
  }
  return changed;
}

} // namespace stretch::app

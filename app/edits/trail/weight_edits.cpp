#include "app/edits/trail/weight_edits.h"

#include <algorithm>

#include "app/document.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/starting_settings.h"
#include "app/schema/weight_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

Status validate(const WeightSettings& settings) {
  if (Status values = checkSettings(weightSchema(), settings); !values) {
    return values;
  }
  const bool hasLength = !settings.rangeFrames || settings.rangeFrames->x < settings.rangeFrames->y;
  return hasLength ? Status(Success{})
                   : Status(Error{"the range has no length", "range", "set its end after its start"});
}

} // namespace

Result<Document> setWeight(const Document& document, const WeightedLimb& wanted) {
  if (const Status known = checkLimbAndClip(document, wanted.limb, wanted.clip); !known) {
    return known.error();
  }
  if (const Status valid = validate(wanted.settings); !valid) {
    return valid.error();
  }
  Document changed = document;
  const auto present =
      std::find_if(changed.weights.begin(), changed.weights.end(), [&](const WeightedLimb& entry) {
        return entry.limb == wanted.limb && entry.clip == wanted.clip;
      });
  if (present != changed.weights.end()) {
    *present = wanted;
  } else {
    changed.weights.push_back(wanted);
  }
  return changed;
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

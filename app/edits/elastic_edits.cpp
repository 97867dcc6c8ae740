#include "app/edits/elastic_edits.h"

#include <algorithm>
#include <cmath>

#include "app/edits/trail_edits.h"
#include "app/schema/elastic_description.h"
#include "app/weight/elastic.h"

namespace stretch::app {

namespace {

// Numbers that the panel or a caller may have got wrong; files and options are checked where they are read.
Status validate(const ElasticSettings& settings) {
  ElasticSettings scratch;
  for (const ElasticSetting& setting : elasticSettings()) {
    if (const Status valid = setElasticSetting(setting, setting.read(settings), scratch); !valid) {
      return valid;
    }
  }
  const bool hasLength = !settings.rangeFrames || settings.rangeFrames->x < settings.rangeFrames->y;
  return hasLength ? Status(Success{})
                   : Status(Error{"the range has no length", "range", "set its end after its start"});
}

} // namespace

Result<Document> setElastic(const Document& document, const ElasticLimb& wanted) {
  if (const Status known = checkLimbAndClip(document, wanted.limb, wanted.clip); !known) {
    return known.error();
  }
  if (const Status valid = validate(wanted.settings); !valid) {
    return valid.error();
  }
  Document changed = document;
  const auto present =
      std::find_if(changed.elastic.begin(), changed.elastic.end(), [&](const ElasticLimb& entry) {
        return entry.limb == wanted.limb && entry.clip == wanted.clip;
      });
  if (present != changed.elastic.end()) {
    *present = wanted;
  } else {
    changed.elastic.push_back(wanted);
  }
  return changed;
}

Document removeElastic(const Document& document, const std::string& limb, int clip) {
  Document changed = document;
  std::erase_if(changed.elastic,
                [&](const ElasticLimb& entry) { return entry.limb == limb && entry.clip == clip; });
  return changed;
}

Result<Document> switchElastic(const Document& document, const std::vector<std::string>& limbs, int clip,
                               bool on) {
  Document changed = document;
  for (const std::string& limb : limbs) {
    const ElasticLimb* const present = findElastic(changed, limb, clip);
    if (present == nullptr && !on) {
      continue;
    }
    ElasticLimb entry = present != nullptr ? *present : ElasticLimb{limb, clip, true, {}};
    entry.on = on;
    Result<Document> next = setElastic(changed, entry);
    if (!next) {
      return next.error();
    }
    changed = std::move(*next);
  }
  return changed;
}

} // namespace stretch::app

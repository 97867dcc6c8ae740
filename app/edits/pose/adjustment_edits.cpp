#include "app/edits/pose/adjustment_edits.h"

#include <algorithm>

namespace stretch::app {

Result<Document> placeAdjustments(const Document& document, std::span<const rig::Adjustment> wanted,
                                  Entry entry) {
  return documentOf(placeOf<rig::Adjustment>(document, {wanted.begin(), wanted.end()}, entry));
}

Document removeAdjustments(const Document& document, const std::string& controller, int clip) {
  Document changed = document;
  std::erase_if(changed.adjustments, [&](const rig::Adjustment& adjustment) {
    return adjustment.controller == controller && adjustment.clip == clip;
  });
  return changed;
}

} // namespace stretch::app

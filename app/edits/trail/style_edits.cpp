#include "app/edits/trail/style_edits.h"

#include <algorithm>
#include <cmath>

#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

namespace {

constexpr std::array<Style, 6> table{{{"Duck Amuck (1953)", 2.0, 2.0, 2.0},
                                      {"Fast and Furry-ous (1949)", 2.25, 1.75, 1.5},
                                      {"Tortoise Wins by a Hare (1943)", 2.4, 1.3, 1.6},
                                      {"The Great Piggy Bank Robbery (1946)", 2.0, 1.5, 4.0},
                                      {"Stop! Look! and Hasten! (1955)", 2.0, 1.12, 2.0},
                                      {"What's Opera, Doc? (1957)", 1.4, 1.4, 1.4}}};

rig::LimbKind kindOf(const Document& document, const rig::Trail& trail) {
  const rig::Limb* limb = findLimb(document, trail.limb);
  return limb != nullptr ? limb->kind : rig::LimbKind::chain;
}

} // namespace

const std::array<Style, 6>& styles() {
  return table;
}

double scaleOf(const Style& style, rig::LimbKind kind) {
  switch (kind) {
  case rig::LimbKind::spine:
  case rig::LimbKind::neck:
    return style.torso;
  case rig::LimbKind::leg:
    return style.leg;
  default:
    break;
  }
  return style.arm;
}

Result<Document> applyStyle(const Document& document, const std::vector<int>& trailIds, const Style& style) {
  Document changed = document;
  for (const int id : trailIds) {
    const rig::Trail* trail = findTrail(document, id);
    if (trail == nullptr) {
      return missingTrail(id);
    }
    rig::TrailSettings settings = trail->settings;
    settings.scale = scaleOf(style, kindOf(document, *trail));
    Result<Document> next = setTrailSettings(changed, id, settings);
    if (!next) {
      return next;
    }
    changed = std::move(next).value();
  }
  return changed;
}

bool hasStyle(const Document& document, const std::vector<int>& trailIds, const Style& style) {
  return std::all_of(trailIds.begin(), trailIds.end(), [&](int id) {
    const rig::Trail* trail = findTrail(document, id);
    return trail != nullptr &&
           std::abs(trail->settings.scale - scaleOf(style, kindOf(document, *trail))) < 1e-9;
  });
}

} // namespace stretch::app

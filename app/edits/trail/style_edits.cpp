#include "app/edits/trail/style_edits.h"

#include <algorithm>

#include "app/edits/trail/starting_settings.h"
#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

namespace {

rig::LimbKind kindOf(const Document& document, const rig::Trail& trail) {
  const rig::Limb* limb = findLimb(document, trail.limb);
  return limb != nullptr ? limb->kind : rig::LimbKind::chain;
}

// A way back and a swing of an earlier style are no part of the next one.
rig::TrailSettings styledTrail(const Document& document, const rig::Trail& trail, const rig::Style& style) {
  rig::TrailSettings plain = trail.settings;
  const rig::Limb* const limb = findLimb(document, trail.limb);
  plain.overshoot = limb != nullptr ? usualTrail(document, *limb).overshoot : 0.0;
  plain.releaseFrames.reset();
  plain.lingerFrames = 0.0;
  return rig::styledSettings(plain, style, kindOf(document, trail), 1.0);
}

} // namespace

Result<Document> applyStyle(const Document& document, const std::vector<int>& trailIds,
                            const rig::Style& style) {
  Document changed = document;
  for (const int id : trailIds) {
    const rig::Trail* trail = findTrail(document, id);
    if (trail == nullptr) {
      return missingTrail(id);
    }
    Result<Document> next = setTrailSettings(changed, id, styledTrail(document, *trail, style));
    if (!next) {
      return next;
    }
    changed = std::move(next).value();
  }
  return changed;
}

bool hasStyle(const Document& document, const std::vector<int>& trailIds, const rig::Style& style) {
  return std::all_of(trailIds.begin(), trailIds.end(), [&](int id) {
    const rig::Trail* trail = findTrail(document, id);
    return trail != nullptr && trail->settings == styledTrail(document, *trail, style);
  });
}

Result<rig::Style> styleOfClip(const Document& document, int clip, const std::string& name) {
  std::vector<rig::StyledLimb> limbs;
  for (const rig::Trail& trail : document.trails) {
    if (trail.clip == clip && trail.exaggerated) {
      limbs.push_back({kindOf(document, trail), trail.settings});
    }
  }
  const std::string& clipName = clipOf(document, clip).name;
  if (limbs.empty()) {
    return Error{"no trail of the clip is exaggerated", clipName, "exaggerate a limb of it first"};
  }
  rig::Style style = rig::styleOf(limbs, !name.empty() ? name : clipName.empty() ? "My style" : clipName);
  for (const WeightedLimb& limb : document.weights) {
    if (limb.clip == clip && limb.on && limb.settings.amount > style.weight.amount) {
      style.weight = {limb.settings.amount, limb.settings.stiffness, limb.settings.damping};
    }
  }
  return style;
}

} // namespace stretch::app

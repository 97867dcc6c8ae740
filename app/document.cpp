#include "app/document.h"

#include <algorithm>

#include "core/base/check.h"

namespace stretch::app {

namespace {

template <typename Trails>
auto findById(Trails& trails, int trailId) -> decltype(trails.data()) {
  const auto found =
      std::ranges::find_if(trails, [&](const rig::Trail& trail) { return trail.id == trailId; });
  return found == trails.end() ? nullptr : &*found;
}

bool sameClips(const Document& a, const Document& b) {
  return a.clips == b.clips || (a.clips != nullptr && b.clips != nullptr && *a.clips == *b.clips);
}

} // namespace

bool sameDocument(const Document& a, const Document& b) {
  return sameInFile(a, b) && a.references == b.references;
}

bool sameInFile(const Document& a, const Document& b) {
  return a.source == b.source && a.scene == b.scene && a.addedFiles == b.addedFiles && sameClips(a, b) &&
         a.body.limbs == b.body.limbs && a.body.plan == b.body.plan && a.body.hips == b.body.hips &&
         a.limbsCorrected == b.limbsCorrected && a.locators == b.locators && a.chains == b.chains &&
         a.trails == b.trails && a.adjustments == b.adjustments && a.holds == b.holds &&
         a.weights == b.weights && a.followingKeys == b.followingKeys && a.loopingClips == b.loopingClips &&
         a.rates == b.rates && a.selectionSets == b.selectionSets;
}

std::vector<rig::Limb> allLimbs(const Document& document) {
  std::vector<rig::Limb> limbs = document.body.limbs;
  limbs.insert(limbs.end(), document.chains.begin(), document.chains.end());
  return limbs;
}

const rig::Limb* findLimb(const Document& document, const std::string& limbId) {
  for (const std::vector<rig::Limb>* limbs : {&document.body.limbs, &document.chains}) {
    const auto found =
        std::find_if(limbs->begin(), limbs->end(), [&](const rig::Limb& limb) { return limb.id == limbId; });
    if (found != limbs->end()) {
      return &*found;
    }
  }
  return nullptr;
}

const rig::Trail* findTrail(const Document& document, int trailId) {
  return findById(document.trails, trailId);
}
rig::Trail* findTrail(Document& document, int trailId) {
  return findById(document.trails, trailId);
}

Document adjustedOnly(Document document) {
  document.trails.clear();
  document.holds = {};
  document.weights.clear();
  return document;
}

const Clip& clipOf(const Document& document, int clip) {
  check(clip >= 0 && static_cast<std::size_t>(clip) < document.clips->size(),
        "the clip is one of the document's");
  return (*document.clips)[static_cast<std::size_t>(clip)];
}

const std::shared_ptr<const std::vector<Clip>>& sourceClipsOf(const Document& document) {
  return document.sourceClips != nullptr ? document.sourceClips : document.clips;
}

const Clip& sourceClipOf(const Document& document, int clip) {
  const std::vector<Clip>& clips = *sourceClipsOf(document);
  check(clip >= 0 && static_cast<std::size_t>(clip) < clips.size(), "the clip is one of the document's");
  return clips[static_cast<std::size_t>(clip)];
}

bool isLooping(const Document& document, int clip) {
  return std::ranges::find(document.loopingClips, clip) != document.loopingClips.end();
}

const WeightedLimb* findWeight(const Document& document, const std::string& limb, int clip) {
  const auto found = std::ranges::find_if(
      document.weights, [&](const WeightedLimb& entry) { return entry.limb == limb && entry.clip == clip; });
  return found == document.weights.end() ? nullptr : &*found;
}

bool hasWeight(const Document& document, int clip) {
  return std::ranges::any_of(document.weights, [&](const WeightedLimb& entry) {
    return entry.on && entry.clip == clip && findLimb(document, entry.limb) != nullptr;
  });
}

std::size_t disconnectedTrails(const Document& document) {
  return static_cast<std::size_t>(std::ranges::count_if(
      document.trails, [](const rig::Trail& trail) { return trail.exaggerated && !trail.connected; }));
}

} // namespace stretch::app

#include "app/files/save.h"

#include <set>
#include <utility>

#include "app/evaluate/evaluate.h"
#include "app/files/saved_work.h"
#include "core/gltf/json.h"
#include "rig/rekey/bind_leaves.h"
#include "rig/rekey/rekey.h"

namespace stretch::app {

namespace {

constexpr double toleranceOfHeight = 1e-4; // docs/exaggeration.md, What saving writes

// The document as it was applied: each trail with the settings that it was applied with.
Document appliedOnly(Document document) {
  std::erase_if(document.trails, [](const rig::Trail& trail) { return !trail.applied.has_value(); });
  for (rig::Trail& trail : document.trails) {
    trail.settings = *trail.applied;
  }
  return document;
}

std::set<int> clipsToKey(const Document& document) {
  std::set<int> clips;
  for (const WeightedLimb& entry : document.weights) {
    if (hasWeight(document, entry.clip)) {
      clips.insert(entry.clip);
    }
  }
  for (const rig::Trail& trail : document.trails) {
    clips.insert(trail.clip);
  }
  return clips;
}

} // namespace

Result<gltf::Edits> editsOf(const Document& document, const SaveOptions& options) {
  gltf::Edits edits;
  const Document applied = appliedOnly(document);
  std::vector<rig::ClipStretches> stretches;
  rig::RekeyOptions rekeyOptions;
  // Joints and the stretch of a bone may each miss by this, so a vertex by both; and key times and values are
  // rounded to single precision on their way into the file.
  rekeyOptions.tolerance = 0.33 * toleranceOfHeight * document.biped.height;
  rekeyOptions.keyEveryFrame = options.keyEveryFrame;
  for (const int clip : clipsToKey(applied)) {
    rig::RekeyedClip rekeyed =
        rig::rekey(*applied.scene, clipOf(applied, clip), prepareMotion(applied, clip), rekeyOptions);
    edits.clips.push_back({clip, std::move(rekeyed.tracks)});
    stretches.push_back({clip, std::move(rekeyed.stretches)});
  }
  if (!options.keepSkeleton) {
    rig::addBindLeaves(*applied.scene, stretches, edits);
  }
  if (!options.clean) {
    edits.work = workOf(document);
  }
  return edits;
}

Status saveDocument(const Document& document, const std::filesystem::path& path, const SaveOptions& options) {
  const Result<gltf::Edits> edits = editsOf(document, options);
  if (!edits) {
    return edits.error();
  }
  if (edits->empty()) {
    return gltf::save(*document.source, path);
  }
  const Result<gltf::Source> changed = gltf::patched(*document.source, *edits);
  return changed ? gltf::save(*changed, path) : Status(changed.error());
}

} // namespace stretch::app

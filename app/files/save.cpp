#include "app/files/save.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/edits/keys/rate_edits.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/keyed_clip.h"
#include "app/files/saved_work.h"
#include "app/things/thing.h"
#include "core/anim/frames.h"
#include "core/gltf/json/json.h"
#include "core/scene/bind_chains.h"
#include "core/scene/stray_vertices.h"
#include "rig/rekey/bind_leaves.h"
#include "rig/rekey/rekey.h"

namespace stretch::app {

namespace {

// What is seen, and so what is keyed: the trails that the character follows, and weight that is on.
Document seenOnly(Document document) {
  std::erase_if(document.trails, [](const rig::Trail& trail) { return !trail.connected; });
  std::erase_if(document.weights, [](const WeightedLimb& weight) { return !weight.on; });
  return document;
}

std::set<int> clipsToKey(const Document& document) {
  std::set<int> clips;
  eachList(document, [&](const auto& list) {
    for (const auto& thing : list) {
      clips.insert(thing.clip);
    }
  });
  for (int clip = 0; hasEditedKeys(document) && clip < static_cast<int>(document.clips->size()); ++clip) {
    if (!editedTracks(document, clip).empty()) {
      clips.insert(clip);
    }
  }
  return clips;
}

// The tracks that the user edited and those that the motion re-keys, which come from them.
std::vector<Track> joinedTracks(std::vector<Track> edited, std::vector<Track> rekeyed) {
  std::erase_if(edited, [&](const Track& track) {
    return std::ranges::any_of(rekeyed, [&](const Track& other) {
      return other.node == track.node && other.channel == track.channel;
    });
  });
  edited.insert(edited.end(), std::make_move_iterator(rekeyed.begin()),
                std::make_move_iterator(rekeyed.end()));
  return edited;
}

// Frames count in the own rate of the clip, also where the keys in the file tell another.
void noteRates(const Document& document, gltf::Edits& edits) {
  for (gltf::ClipTracks& clip : edits.clips) {
    const double own = ownRate(document, clip.clip);
    const double told =
        guessFramesPerSecond(rig::withTracks(clipOf(document, clip.clip), clip.tracks).tracks);
    clip.framesPerSecond = told == own ? 0.0 : own;
  }
}

// The four influences that are kept of a vertex in a file: the strongest.
VertexInfluences strongestOf(const VertexInfluences& vertex) {
  std::array<std::size_t, VertexInfluences::capacity> slots{};
  std::iota(slots.begin(), slots.end(), std::size_t{0});
  std::ranges::stable_sort(slots, std::ranges::greater(),
                           [&](std::size_t slot) { return vertex.weights[slot]; });
  VertexInfluences kept;
  float sum = 0.0F;
  for (std::size_t i = 0; i < 4; ++i) {
    kept.joints[i] = vertex.joints[slots[i]];
    kept.weights[i] = vertex.weights[slots[i]];
    sum += kept.weights[i];
  }
  for (float& weight : kept.weights) {
    weight /= sum;
  }
  return kept;
}

// Weights that are no numbers look different in every viewer; those that stand in their place are what is
// seen here.
void writeMendedInfluences(const Scene& scene, gltf::Edits& edits) {
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const Node& shown = scene.nodes[node];
    const bool isBound = std::ranges::any_of(
        edits.boundMeshes, [&](const gltf::BoundMesh& bound) { return bound.node == NodeIndex(node); });
    if (shown.mesh < 0 || shown.skin < 0 || isBound) {
      continue;
    }
    const std::vector<Primitive>& primitives = scene.meshes[static_cast<std::size_t>(shown.mesh)].primitives;
    if (std::ranges::none_of(primitives, &Primitive::areInfluencesMended)) {
      continue;
    }
    gltf::BoundMesh bound{NodeIndex(node), shown.skin, {}};
    for (const Primitive& primitive : primitives) {
      std::ranges::transform(primitive.influences, std::back_inserter(bound.influences.emplace_back()),
                             strongestOf);
    }
    edits.boundMeshes.push_back(std::move(bound));
  }
}

// Moments at which vertices with too many influences are fitted: of every clip, those that are stretched most
// of all, and the rest pose.
std::vector<FrameState> fittedMoments(const Document& seen,
                                      const std::vector<rig::ClipStretches>& stretches) {
  constexpr double ofStretchedClip = 96.0;
  constexpr double ofOthers = 96.0; // together
  const std::size_t clips = seen.clips->size();
  std::vector<FrameState> moments{frameOf(*seen.scene, restPose(*seen.scene), 0.0)};
  for (std::size_t i = 0; i < clips; ++i) {
    const int index = static_cast<int>(i);
    const bool isStretched = std::ranges::any_of(stretches, [&](const rig::ClipStretches& clip) {
      return clip.clip == index && !clip.stretches.empty();
    });
    const Clip& clip = clipOf(seen, index);
    const double most = isStretched ? ofStretchedClip : ofOthers / static_cast<double>(clips);
    const double step = 0.25 * std::max(1.0, std::ceil(4.0 * lastFrame(clip) / std::max(most, 1.0)));
    const rig::MotionState motion = prepareMotion(seen, index);
    for (double frame = 0.0; frame <= lastFrame(clip); frame += step) {
      moments.push_back(evaluate(seen, motion, frame / clip.framesPerSecond));
    }
  }
  return moments;
}

// Parts the stretches by what carries them: a joint that has leaves or corners keeps them.
void addStretches(const Document& seen, const std::vector<rig::ClipStretches>& stretches,
                  const SavedForm& form, SavedEdits& saved) {
  std::vector<rig::ClipStretches> onLeaves;
  std::vector<rig::ClipStretches> onCorners;
  for (const rig::ClipStretches& clip : stretches) {
    onLeaves.push_back({clip.clip, {}});
    onCorners.push_back({clip.clip, {}});
    for (const rig::StretchKeys& stretch : clip.stretches) {
      const BindChain* const made = findBindChain(*seen.scene, stretch.node);
      const bool usesCorners = made != nullptr ? !made->corners.empty() : form.form == StretchForm::volume;
      (usesCorners ? onCorners : onLeaves).back().stretches.push_back(stretch);
    }
  }
  rig::addBindLeaves(*seen.scene, onLeaves, saved.edits);
  if (std::ranges::any_of(onCorners, [](const auto& clip) { return !clip.stretches.empty(); })) {
    const rig::CornerOptions options{static_cast<std::size_t>(form.influences), seen.body.height,
                                     fittedMoments(seen, stretches)};
    saved.fit = rig::addBindCorners(*seen.scene, onCorners, options, saved.edits);
  }
}

} // namespace

SavedEdits editsOf(const Document& document, const SaveOptions& options) {
  EvaluationCache cache;
  return editsOf(document, options, cache);
}

SavedEdits editsOf(const Document& document, const SaveOptions& options, EvaluationCache& cache) {
  SavedEdits saved;
  gltf::Edits& edits = saved.edits;
  edits.addedFiles = document.addedFiles;
  const Document seen = seenOnly(document);
  std::vector<rig::ClipStretches> stretches;
  rig::RekeyOptions rekeyOptions = keyingOptions(document);
  rekeyOptions.places = options.form.keys;
  for (const int clip : clipsToKey(seen)) {
    rig::RekeyedClip rekeyed =
        rig::rekey(*seen.scene, clipOf(seen, clip), *cache.motion(seen, clip), rekeyOptions);
    saved.missOfHeight = std::max(saved.missOfHeight, rekeyed.largestMiss / document.body.height);
    std::vector<Track> tracks = joinedTracks(editedTracks(seen, clip), std::move(rekeyed.tracks));
    if (tracks.empty() && rekeyed.stretches.empty()) {
      continue;
    }
    edits.clips.push_back({clip, std::move(tracks)});
    stretches.push_back({clip, std::move(rekeyed.stretches)});
  }
  if (options.form.form != StretchForm::translation) {
    addStretches(seen, stretches, options.form, saved);
  }
  noteRates(document, edits);
  writeMendedInfluences(*document.scene, edits);
  if (!options.clean) {
    edits.work = workOf(document);
  }
  return saved;
}

Status saveDocument(const Document& document, const std::filesystem::path& path, const SaveOptions& options) {
  return saveEdits(document, editsOf(document, options).edits, path);
}

Status saveEdits(const Document& document, const gltf::Edits& edits, const std::filesystem::path& path) {
  if (edits.empty()) {
    return gltf::save(*document.source, path);
  }
  Result<gltf::Source> changed = gltf::patched(*document.source, edits);
  return changed ? gltf::save(std::move(*changed), path) : Status(changed.error());
}

std::vector<std::string> besideLines(const gltf::Source& source, const std::filesystem::path& output) {
  const std::vector<std::filesystem::path> files = gltf::filesBeside(source, output);
  if (files.empty()) {
    return {};
  }
  const std::string others = files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : std::string();
  return {fmt::format("{} needs {}{}, written beside it; move them together", output.filename().string(),
                      files.front().string(), others)};
}

Result<Document> openDocument(const std::filesystem::path& path, gltf::Tolerance tolerance,
                              gltf::Pictures pictures) {
  Result<gltf::Loaded> loaded = gltf::load(path, tolerance, pictures);
  if (!loaded) {
    return loaded.error();
  }
  Document document;
  document.source = loaded->source;
  document.addedFiles = std::move(loaded->added);
  document.scene = loaded->scene;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(loaded->clips));
  document.warnings = std::move(loaded->warnings);
  std::ranges::move(strayVertexWarnings(*document.scene), std::back_inserter(document.warnings));
  document.body = bodyOfSource(document);
  if (!loaded->savedWork.isNull()) {
    if (const Status restored = restoreWork(loaded->savedWork, document); !restored) {
      document.warnings.push_back("the work kept in the file could not be taken up: " +
                                  restored.error().line());
    } else {
      document.carriedWork = true;
    }
  }
  return document;
}

} // namespace stretch::app

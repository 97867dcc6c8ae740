#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/clip_reference.h"
#include "app/selection_set.h"
#include "app/weight/weight_settings.h"
#include "core/anim/clip.h"
#include "core/gltf/source/source.h"
#include "core/scene/scene.h"
#include "rig/body/locators/locators.h"
#include "rig/body/reading/detection.h"
#include "rig/controllers/adjustment.h"
#include "rig/hold/hold.h"
#include "rig/limb.h"
#include "rig/trail/trail.h"

namespace stretch::app {

/// The rate that the user chose for a clip.
struct ClipRate {
  int clip = 0;
  double framesPerSecond = 0.0;
  double own = 0.0; ///< Rate that its keys suggest.

  friend bool operator==(const ClipRate&, const ClipRate&) = default;
};

/// The keys of one of a clip's own tracks whose tangents follow their neighbours.
struct FollowingKeys {
  struct Key {
    float seconds = 0.0F;
    unsigned components = 0; ///< Bit i: component i of the shown value.
    friend bool operator==(const Key&, const Key&) = default;
  };
  int clip = 0;
  NodeIndex node;
  Channel channel = Channel::translation;
  std::vector<Key> keys; ///< Ascending; of keys that the track has.

  friend bool operator==(const FollowingKeys&, const FollowingKeys&) = default;
};

/// Everything that is edited, undone and saved, as one value: copying it is cheap, since large parts are
/// shared and never change. Nothing derived is kept here. Clips are the source's with the keys that the user
/// edited: what adjustments and trails make of them is evaluated, so deleting one gives the clip back by
/// construction.
struct Document {
  std::shared_ptr<const gltf::Source> source;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const std::vector<Clip>> clips;
  /// Clips as the file has them, where keys of its own clips were edited (edits/track_edits.h); null: nothing
  /// was.
  std::shared_ptr<const std::vector<Clip>> sourceClips;
  /// How many of the last clips came from other files since this one was opened: the source has them, its
  /// file may not (edits/import_clip.h).
  std::size_t importedClips = 0;
  /// Props from files of their own, beside the source; `scene` holds them (edits/prop_file_edits.h).
  std::vector<gltf::AddedFile> addedFiles;
  std::vector<FollowingKeys> followingKeys; ///< Keys of tracks that have auto tangents, in the order of
                                            ///< setting.
  std::vector<std::string> warnings;        ///< Warnings of opening the file and those that were added.
  bool carriedWork = false;                 ///< The file was one of ours: saving goes back to it.

  rig::Body body;              ///< Limbs as found, or as corrected by hand.
  bool limbsCorrected = false; ///< The user changed a limb: saved even without a trail.
  rig::Locators locators; ///< Places where joints of a body without a skeleton are to stand; empty: none.
  std::vector<rig::Limb> chains; ///< Further chains that the user picked.
  std::vector<rig::Trail> trails;
  std::vector<rig::Adjustment> adjustments; ///< Changes by controllers in the clips, before any trail.
  rig::Holds holds;                         ///< Pins, grips and props, on top of the trails.
  std::vector<WeightedLimb> weights;        ///< Limbs with weight, by clip.
  std::vector<int> loopingClips;            ///< Clips that the user marked as loops: releases wrap.
  std::vector<ClipRate> rates;              ///< Clips that are worked on at another rate than their own.
  std::vector<SelectionSet> selectionSets;  ///< In the order in which they were kept.
  std::vector<Reference> references;        ///< By clip, at most one of each; no part of the saved file.
  int nextTrailId = 1;
};

/// Equal by value (shared parts by identity first).
[[nodiscard]] bool sameDocument(const Document& a, const Document& b);
/// Equal in all that a saved file holds: whatever they refer to.
[[nodiscard]] bool sameInFile(const Document& a, const Document& b);

/// Bytes that a document takes and does not share with another one, about.
[[nodiscard]] std::size_t bytesBeyond(const Document& document, const Document& other);

/// The limbs of the body, then the chains: what trails and weight may name.
[[nodiscard]] std::vector<rig::Limb> allLimbs(const Document& document);

/// Null when there is none.
[[nodiscard]] const rig::Limb* findLimb(const Document& document, const std::string& limbId);
[[nodiscard]] const rig::Trail* findTrail(const Document& document, int trailId);
[[nodiscard]] rig::Trail* findTrail(Document& document, int trailId);

/// With its adjustments alone: what trails, holds and weight make of a pose is left out.
[[nodiscard]] Document adjustedOnly(Document document);

[[nodiscard]] const Clip& clipOf(const Document& document, int clip);

/// The clips, and a clip, without the edits of its own keys.
[[nodiscard]] const std::shared_ptr<const std::vector<Clip>>& sourceClipsOf(const Document& document);
[[nodiscard]] const Clip& sourceClipOf(const Document& document, int clip);

/// Whether the clip is marked as a loop.
[[nodiscard]] bool isLooping(const Document& document, int clip);

/// Exaggerated trails that the character does not follow: saving keeps them in the work and does not key
/// them.
[[nodiscard]] std::size_t disconnectedTrails(const Document& document);

/// Null when the limb has no weight in the clip.
[[nodiscard]] const WeightedLimb* findWeight(const Document& document, const std::string& limb, int clip);

/// Whether any limb of the clip has weight that is on.
[[nodiscard]] bool hasWeight(const Document& document, int clip);

} // namespace stretch::app

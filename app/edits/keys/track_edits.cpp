#include "app/edits/keys/track_edits.h"

#include <algorithm>
#include <utility>

#include "rig/rekey/rekey.h"

namespace stretch::app {

namespace {

using Clips = std::vector<Clip>;

// What is the source's again is shared with it.
void shareWithSource(const Clip& source, Clip& clip) {
  for (std::size_t i = 0; i < std::min(source.tracks.size(), clip.tracks.size()); ++i) {
    if (clip.tracks[i] == source.tracks[i]) {
      clip.tracks[i] = source.tracks[i];
    }
  }
}

bool sameTracks(const Clips& a, const Clips& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].tracks == b[i].tracks)) {
      return false;
    }
  }
  return true;
}

Document withClips(const Document& document, Clips clips) {
  const std::shared_ptr<const Clips>& source = sourceClipsOf(document);
  Document changed = document;
  changed.sourceClips = sameTracks(clips, *source) ? nullptr : source;
  changed.clips = std::make_shared<const Clips>(std::move(clips));
  return changed;
}

} // namespace

bool hasEditedKeys(const Document& document) {
  return document.sourceClips != nullptr;
}

std::vector<Track> editedTracks(const Document& document, int clip) {
  std::vector<Track> edited;
  if (!hasEditedKeys(document)) {
    return edited;
  }
  const Clip& source = sourceClipOf(document, clip);
  const Clip& shown = clipOf(document, clip);
  for (std::size_t i = 0; i < shown.tracks.size(); ++i) {
    if (i >= source.tracks.size() || !(shown.tracks[i] == source.tracks[i])) {
      edited.push_back(*shown.tracks[i]);
    }
  }
  return edited;
}

Document setTracks(const Document& document, int clip, const std::vector<Track>& tracks) {
  Clips clips = *document.clips;
  Clip& edited = clips[at(clip)];
  edited = rig::withTracks(edited, tracks);
  shareWithSource(sourceClipOf(document, clip), edited);
  setEndsFromKeys(edited);
  return withClips(document, std::move(clips));
}

Document restoreTracks(const Document& document, int clip, const TrackChoice& which) {
  Clips clips = *document.clips;
  Clip& restored = clips[at(clip)];
  const Clip& source = sourceClipOf(document, clip);
  std::vector<CopyOnWrite<Track>> tracks;
  for (std::size_t i = 0; i < restored.tracks.size(); ++i) {
    const CopyOnWrite<Track>& track = restored.tracks[i];
    if (!which(track->node, track->channel)) {
      tracks.push_back(track);
    } else if (i < source.tracks.size()) {
      tracks.push_back(source.tracks[i]);
    }
  }
  restored.tracks = std::move(tracks);
  setEndsFromKeys(restored);
  Document changed = withClips(document, std::move(clips));
  std::erase_if(changed.followingKeys, [&](const FollowingKeys& following) {
    return following.clip == clip && which(following.node, following.channel);
  });
  return changed;
}

Document restoreAllTracks(const Document& document) {
  Document restored = document;
  restored.followingKeys.clear();
  for (int clip = 0; hasEditedKeys(restored) && clip < static_cast<int>(document.clips->size()); ++clip) {
    restored = restoreTracks(restored, clip, [](NodeIndex, Channel) { return true; });
  }
  return restored;
}

} // namespace stretch::app

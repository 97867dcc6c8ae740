#include "rig/rekey/rekey.h"

#include <algorithm>

#include "rig/rekey/exact_motion.h"
#include "rig/rekey/key_times.h"
#include "rig/rekey/stretch_build.h"
#include "rig/rekey/track_build.h"

namespace stretch::rig {

namespace {

struct Piece {
  Window window;
  std::vector<double> times;
};

// Windows of two trails that change the same property and overlap become one, with the keys of both.
void mergePieces(std::vector<Piece>& pieces) {
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.window.startSeconds < b.window.startSeconds; });
  std::vector<Piece> merged;
  for (Piece& piece : pieces) {
    if (merged.empty() || piece.window.startSeconds > merged.back().window.endSeconds) {
      merged.push_back(std::move(piece));
      continue;
    }
    Piece& into = merged.back();
    if (piece.window.endSeconds >= into.window.endSeconds) {
      into.window.endSeconds = piece.window.endSeconds;
      into.window.jumpsAfter = piece.window.jumpsAfter;
    }
    into.times.insert(into.times.end(), piece.times.begin(), piece.times.end());
    std::sort(into.times.begin(), into.times.end());
    into.times.erase(std::unique(into.times.begin(), into.times.end()), into.times.end());
  }
  pieces = std::move(merged);
}

ChannelKeys keysOfChannel(const ChangedChannel& channel, const std::vector<TrailKeys>& trails) {
  std::vector<Piece> pieces;
  for (const TrailKeys& trail : trails) {
    const bool changes =
        std::any_of(trail.channels.begin(), trail.channels.end(), [&](const ChangedChannel& other) {
          return other.node == channel.node && other.channel == channel.channel;
        });
    for (std::size_t i = 0; changes && i < trail.windows.size(); ++i) {
      pieces.push_back({trail.windows[i], trail.times[i]});
    }
  }
  mergePieces(pieces);
  ChannelKeys keys{channel, {}, {}};
  for (Piece& piece : pieces) {
    keys.windows.push_back(piece.window);
    keys.times.push_back(std::move(piece.times));
  }
  return keys;
}

bool hasTrack(const std::vector<Track>& tracks, const ChangedChannel& channel) {
  return std::any_of(tracks.begin(), tracks.end(), [&](const Track& track) {
    return track.node == channel.node && track.channel == channel.channel;
  });
}

bool hasStretch(const std::vector<StretchKeys>& stretches, int node) {
  return std::any_of(stretches.begin(), stretches.end(),
                     [&](const StretchKeys& keys) { return keys.node == node; });
}

} // namespace

RekeyedClip rekey(const Scene& scene, const Clip& clip, const MotionState& motion,
                  const RekeyOptions& options) {
  ExactMotion exact(scene, clip, motion);
  std::vector<TrailKeys> trails;
  for (const SolvedTrail& trail : motion.trails) {
    if (trail.active) {
      trails.push_back(chooseKeys(exact, trail, options));
    }
  }
  RekeyedClip rekeyed;
  for (const TrailKeys& trail : trails) {
    for (const ChangedChannel& channel : trail.channels) {
      if (!hasTrack(rekeyed.tracks, channel)) {
        rekeyed.tracks.push_back(buildTrack(exact, keysOfChannel(channel, trails)));
      }
    }
    for (const int node : trail.stretchedNodes) {
      if (!hasStretch(rekeyed.stretches, node)) {
        rekeyed.stretches.push_back(buildStretch(exact, trails, node));
      }
    }
  }
  return rekeyed;
}

Clip withTracks(const Clip& clip, const std::vector<Track>& tracks) {
  Clip changed = clip;
  for (const Track& track : tracks) {
    const int index = findTrack(clip, track.node, track.channel);
    if (index >= 0) {
      changed.tracks[static_cast<std::size_t>(index)] = CopyOnWrite<Track>(track);
    } else {
      changed.tracks.emplace_back(track);
    }
  }
  return changed;
}

} // namespace stretch::rig

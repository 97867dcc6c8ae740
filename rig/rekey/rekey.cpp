#include "rig/rekey/rekey.h"

#include <algorithm>
#include <cmath>

#include "core/anim/frames.h"
#include "rig/rekey/exact_motion.h"
#include "rig/rekey/key_times.h"
#include "rig/rekey/stretch_build.h"
#include "rig/rekey/track_build.h"

namespace stretch::rig {

namespace {

// A jump at a border that comes to lie inside a larger window keeps its two keys.
void keepInnerJumps(const Window& part, const Window& whole, std::vector<double>& times) {
  if (part.jumpsBefore && part.startSeconds > whole.startSeconds) {
    times.push_back(besideJump(part.startSeconds, -1.0));
  }
  if (part.jumpsAfter && part.endSeconds < whole.endSeconds) {
    times.push_back(besideJump(part.endSeconds, 1.0));
  }
}

void addInto(KeyWindow& into, const KeyWindow& piece) {
  const Window before = into.window;
  extend(into.window, piece.window);
  into.times.insert(into.times.end(), piece.times.begin(), piece.times.end());
  keepInnerJumps(before, into.window, into.times);
  keepInnerJumps(piece.window, into.window, into.times);
  std::sort(into.times.begin(), into.times.end());
  into.times.erase(std::unique(into.times.begin(), into.times.end()), into.times.end());
}

// Windows of two parts that change the same and overlap become one, with the keys of both.
std::vector<KeyWindow> merged(std::vector<KeyWindow> pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const KeyWindow& a, const KeyWindow& b) {
    return a.window.startSeconds < b.window.startSeconds;
  });
  std::vector<KeyWindow> windows;
  for (KeyWindow& piece : pieces) {
    if (windows.empty() || piece.window.startSeconds > windows.back().window.endSeconds) {
      windows.push_back(std::move(piece));
    } else {
      addInto(windows.back(), piece);
    }
  }
  return windows;
}

bool changes(const PartKeys& keys, const ChangedChannel& channel) {
  return std::any_of(keys.channels.begin(), keys.channels.end(), [&](const ChangedChannel& other) {
    return other.node == channel.node && other.channel == channel.channel;
  });
}

ChannelKeys keysOfChannel(const ChangedChannel& channel, const std::vector<PartKeys>& parts) {
  std::vector<KeyWindow> pieces;
  for (const PartKeys& keys : parts) {
    for (std::size_t i = 0; changes(keys, channel) && i < keys.times.size(); ++i) {
      pieces.push_back({keys.part->windows[i], keys.times[i]});
    }
  }
  return {channel, merged(std::move(pieces))};
}

std::vector<KeyWindow> windowsOfStretch(NodeIndex node, const std::vector<PartKeys>& parts) {
  std::vector<KeyWindow> pieces;
  for (const PartKeys& keys : parts) {
    const bool stretches =
        std::find(keys.stretchedNodes.begin(), keys.stretchedNodes.end(), node) != keys.stretchedNodes.end();
    for (std::size_t i = 0; stretches && i < keys.stretchTimes.size(); ++i) {
      pieces.push_back({keys.part->windows[i], keys.stretchTimes[i]});
    }
  }
  return merged(std::move(pieces));
}

// Each property that a part changes, once.
std::vector<ChannelKeys> keysOfChannels(const std::vector<PartKeys>& parts) {
  std::vector<ChannelKeys> channels;
  for (const PartKeys& keys : parts) {
    for (const ChangedChannel& channel : keys.channels) {
      const bool isKnown = std::any_of(channels.begin(), channels.end(), [&](const ChannelKeys& known) {
        return known.channel.node == channel.node && known.channel.channel == channel.channel;
      });
      if (!isKnown) {
        channels.push_back(keysOfChannel(channel, parts));
      }
    }
  }
  return channels;
}

bool standsOnWholeFrames(const Clip& clip) {
  return !clip.tracks.empty() && std::ranges::all_of(clip.tracks, [&](const CopyOnWrite<Track>& track) {
    return std::ranges::all_of(track->times, [&](float time) {
      const double frame = static_cast<double>(time) * clip.framesPerSecond;
      return sameFrame(frame, std::round(frame));
    });
  });
}

RekeyOptions placedFor(const Clip& clip, RekeyOptions options) {
  if (options.places == KeyPlaces::asClip) {
    options.places = standsOnWholeFrames(clip) ? KeyPlaces::wholeFrames : KeyPlaces::needed;
  }
  return options;
}

} // namespace

RekeyedClip rekey(const Scene& scene, const Clip& clip, const MotionState& motion,
                  const RekeyOptions& options) {
  ExactMotion exact(scene, clip, motion);
  const std::vector<KeyedPart> parts = keyedParts(motion);
  const RekeyOptions placed = placedFor(clip, options);
  const ChosenKeys chosen = chooseKeys(exact, parts, placed);
  std::vector<ChannelKeys> channels = keysOfChannels(chosen.parts);
  for (ChannelKeys& channel : channels) {
    channel.framesPerSecond = placed.places == KeyPlaces::wholeFrames ? clip.framesPerSecond : 0.0;
  }
  RekeyedClip rekeyed;
  rekeyed.tracks = buildTracks(exact, channels);
  std::vector<StretchWindows> stretched;
  for (const auto& [node, frames] : chosen.frames) {
    std::vector<KeyWindow> windows = windowsOfStretch(node, chosen.parts);
    if (!windows.empty()) {
      stretched.push_back({node, &frames, std::move(windows)});
    }
  }
  rekeyed.stretches = buildStretches(exact, stretched);
  rekeyed.largestMiss = chosen.largestMiss;
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

#include "rig/rekey/track_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "rig/rekey/source_curve.h"
#include "rig/rekey/span_fit.h"

namespace stretch::rig {

namespace {

std::size_t widthOf(Channel channel) {
  return channel == Channel::rotation ? 4 : 3;
}

bool insideAny(const std::vector<KeyWindow>& windows, double time) {
  return std::any_of(windows.begin(), windows.end(), [&](const KeyWindow& keys) {
    return time >= keys.window.startSeconds - sameKey && time <= keys.window.endSeconds + sameKey;
  });
}

float justBefore(float time) {
  return std::nextafter(time, -std::numeric_limits<float>::infinity());
}
float justAfter(float time) {
  return std::nextafter(time, std::numeric_limits<float>::infinity());
}

// Keys of the source outside the windows. Where the source steps there, each step becomes a pair of
// neighbouring keys.
void addOutsideKeys(const ChannelKeys& keys, std::vector<Key>& out) {
  const Track* source = keys.channel.source;
  if (source == nullptr) {
    return;
  }
  out.reserve(out.size() + source->times.size());
  for (std::size_t i = 0; i < source->times.size(); ++i) {
    const auto time = static_cast<double>(source->times[i]);
    if (insideAny(keys.windows, time)) {
      continue;
    }
    Key key = keyOfSource(*source, i);
    if (source->interpolation == Interpolation::step && i > 0) {
      Key held = keyOfSource(*source, i - 1);
      held.time = justBefore(key.time);
      if (held.value != key.value && !insideAny(keys.windows, static_cast<double>(held.time))) {
        out.push_back(held);
      }
    }
    out.push_back(key);
  }
}

Vec4 exactValue(ExactMotion& exact, const ChangedChannel& channel, double time) {
  return channelValue(exact.at(time).pose, channel.node, channel.channel);
}

// Keys of a window as the exact motion has them, made one after the other; each span of a cubic gets the
// tangents that follow it.
class WindowKeys {
public:
  WindowKeys(const ChangedChannel& channel, const std::vector<double>& times)
      : channel_(&channel), times_(&times) {}

  void makeUpTo(double time, ExactMotion& exact) {
    while (keys_.size() < times_->size() && (*times_)[keys_.size()] <= time) {
      makeNext(exact);
    }
  }
  [[nodiscard]] std::vector<Key> take() { return std::move(keys_); }

private:
  void makeNext(ExactMotion& exact) {
    const std::size_t i = keys_.size();
    Key key;
    key.time = static_cast<float>((*times_)[i]);
    key.value = exactValue(exact, *channel_, (*times_)[i]);
    keys_.push_back(key);
    if (i > 0) {
      const ChannelSpan span = fitSpan(exact, *channel_, (*times_)[i - 1], (*times_)[i]);
      // The span is told on the hemisphere of its start; the key there may already stand on the other one.
      const double side = glm::dot(span.start, keys_[i - 1].value) < 0.0 ? -1.0 : 1.0;
      keys_[i - 1].outTangent = side * span.outTangent;
      keys_[i].inTangent = side * span.inTangent;
      keys_[i].value = side * span.end;
    }
  }

  const ChangedChannel* channel_;
  const std::vector<double>* times_;
  std::vector<Key> keys_;
};

std::vector<double> timesOf(const std::vector<ChannelKeys>& channels) {
  std::vector<double> times;
  for (const ChannelKeys& keys : channels) {
    for (const KeyWindow& window : keys.windows) {
      times.insert(times.end(), window.times.begin(), window.times.end());
    }
  }
  return times;
}

// For each channel, for each of its windows.
std::vector<std::vector<WindowKeys>> exactKeys(ExactMotion& exact, const std::vector<ChannelKeys>& channels) {
  std::vector<std::vector<WindowKeys>> made;
  for (const ChannelKeys& keys : channels) {
    std::vector<WindowKeys>& windows = made.emplace_back();
    for (const KeyWindow& window : keys.windows) {
      windows.emplace_back(keys.channel, window.times);
    }
  }
  for (const double stop : stopsAmong(timesOf(channels))) {
    for (std::vector<WindowKeys>& windows : made) {
      for (WindowKeys& window : windows) {
        window.makeUpTo(stop, exact);
      }
    }
  }
  return made;
}

// At the border of a window the curve outside is the source's: its tangent there, and its own value where it
// has a key with it.
void joinSource(const ChannelKeys& keys, const Key& cut, int outside, Key& key) {
  const bool sameSide = glm::dot(cut.value, key.value) >= 0.0 || keys.channel.channel != Channel::rotation;
  const double side = sameSide ? 1.0 : -1.0;
  constexpr double rounding = 1e-6;
  if (glm::length(side * cut.value - key.value) < rounding * (1.0 + glm::length(key.value))) {
    key.value = side * cut.value;
  }
  (outside < 0 ? key.inTangent : key.outTangent) = side * (outside < 0 ? cut.inTangent : cut.outTangent);
}

// The curve outside a window keeps its shape up to the window's border: after it to the next key of the
// source or the next window, before it from a key of the source, where there is one since the window before.
void joinOutside(const ChannelKeys& keys, std::size_t index, const Key& cut, int outside,
                 std::vector<Key>& out) {
  const Track& source = *keys.channel.source;
  const SourceCurve curve(source, keys.framesPerSecond);
  const auto after = std::upper_bound(source.times.begin(), source.times.end(), cut.time);
  const auto notBefore = std::lower_bound(source.times.begin(), source.times.end(), cut.time);
  if (outside > 0 && after != source.times.end()) {
    const auto next = static_cast<std::size_t>(after - source.times.begin());
    const bool windowFirst =
        index + 1 < keys.windows.size() &&
        keys.windows[index + 1].window.startSeconds <= static_cast<double>(source.times[next]) + sameKey;
    curve.addJoints(cut,
                    windowFirst ? curve.cutAt(static_cast<float>(keys.windows[index + 1].window.startSeconds))
                                : keyOfSource(source, next),
                    out);
  }
  if (outside < 0 && notBefore != source.times.begin()) {
    const auto previous = static_cast<std::size_t>(notBefore - source.times.begin()) - 1;
    if (!insideAny(keys.windows, static_cast<double>(source.times[previous]))) {
      curve.addJoints(keyOfSource(source, previous), cut, out);
    }
  }
}

// The source at a border, as it comes to it from outside: a step right there has not happened yet before it.
Key borderCut(const Track& source, float time, int outside) {
  const SourceCurve curve(source);
  Key cut = curve.cutAt(time);
  if (source.interpolation == Interpolation::step && outside < 0) {
    cut.value = curve.value(static_cast<double>(time) - 2.0 * sameKey);
  }
  return cut;
}

// One border of a window: the curve outside comes to it, in a key that both share or in one of its own where
// the motion jumps or the source steps.
void addBorder(const ChannelKeys& keys, std::size_t index, int outside, Key& border, std::vector<Key>& out) {
  const Window& window = keys.windows[index].window;
  if (keys.channel.source == nullptr) {
    return;
  }
  Key cut = borderCut(*keys.channel.source, border.time, outside);
  joinOutside(keys, index, cut, outside, out);
  const bool jumps = outside < 0 ? window.jumpsBefore : window.jumpsAfter;
  const bool steps = keys.channel.source->interpolation == Interpolation::step && cut.value != border.value;
  // Before the clip's first moment nothing is played, and before its first key a track holds that.
  const bool atStart = outside < 0 && border.time <= std::max(0.0F, keys.channel.source->times.front());
  if (jumps || (steps && outside < 0 && !atStart)) {
    cut.time = outside < 0 ? justBefore(border.time) : justAfter(border.time);
    out.push_back(cut);
  } else {
    joinSource(keys, cut, outside, border);
  }
}

// A channel that the source does not animate rests outside.
void addRest(ExactMotion& exact, const ChangedChannel& channel, float time, std::vector<Key>& out) {
  Key key;
  key.time = time;
  key.value = channelValue(exact.sourceAt(static_cast<double>(time)), channel.node, channel.channel);
  out.push_back(key);
}

void addWindowKeys(ExactMotion& exact, const ChannelKeys& keys, std::size_t index, std::vector<Key> inside,
                   std::vector<Key>& out) {
  const Window& window = keys.windows[index].window;
  addBorder(keys, index, -1, inside.front(), out);
  addBorder(keys, index, 1, inside.back(), out);
  if (keys.channel.source == nullptr && window.jumpsBefore) {
    addRest(exact, keys.channel, justBefore(static_cast<float>(window.startSeconds)), out);
  }
  if (keys.channel.source == nullptr && window.jumpsAfter) {
    addRest(exact, keys.channel, justAfter(static_cast<float>(window.endSeconds)), out);
  }
  out.insert(out.end(), inside.begin(), inside.end());
}

void sortUnique(std::vector<Key>& keys) {
  std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.time < b.time; });
  keys.erase(
      std::unique(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.time == b.time; }),
      keys.end());
}

void negate(Key& key) {
  key.value = -key.value;
  key.inTangent = -key.inTangent;
  key.outTangent = -key.outTangent;
}

// A quaternion and its negative are one rotation, but a spline between them passes through none, and readers
// that lerp do not look at signs: neighbouring keys get neighbouring ones. Keys of the source keep theirs,
// but for those after a window in which the joint turned once round: they are negated together.
void alignHemispheres(std::vector<Key>& keys) {
  bool isNegated = false;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].sourceKey && isNegated) {
      negate(keys[i]);
    }
    const Key* const neighbour = i > 0 ? &keys[i - 1] : (keys.size() > 1 ? &keys[1] : nullptr);
    const bool isOfSource = keys[i].sourceKey && (i == 0 || keys[i - 1].sourceKey);
    if (!isOfSource && neighbour != nullptr && glm::dot(keys[i].value, neighbour->value) < 0.0) {
      negate(keys[i]);
      isNegated = keys[i].sourceKey ? !isNegated : isNegated;
    }
  }
}

void append(const Vec4& numbers, std::size_t width, std::vector<float>& out) {
  for (std::size_t i = 0; i < width; ++i) {
    out.push_back(static_cast<float>(numbers[i]));
  }
}

Track buildTrack(ExactMotion& exact, const ChannelKeys& keys, std::vector<WindowKeys>& inside) {
  std::vector<Key> all;
  for (std::size_t i = 0; i < keys.windows.size(); ++i) {
    addWindowKeys(exact, keys, i, inside[i].take(), all);
  }
  addOutsideKeys(keys, all);
  sortUnique(all);
  if (keys.channel.channel == Channel::rotation) {
    alignHemispheres(all);
  }
  Track track;
  track.node = keys.channel.node;
  track.channel = keys.channel.channel;
  track.width = static_cast<int>(widthOf(track.channel));
  track.sourceChannel = keys.channel.source != nullptr ? keys.channel.source->sourceChannel : -1;
  track.interpolation = keys.channel.isCubic ? Interpolation::cubicSpline : Interpolation::linear;
  const std::size_t width = widthOf(track.channel);
  for (const Key& key : all) {
    track.times.push_back(key.time);
    if (keys.channel.isCubic) {
      append(key.inTangent, width, track.values);
    }
    append(key.value, width, track.values);
    if (keys.channel.isCubic) {
      append(key.outTangent, width, track.values);
    }
  }
  return track;
}

} // namespace

std::vector<Track> buildTracks(ExactMotion& exact, const std::vector<ChannelKeys>& channels) {
  std::vector<std::vector<WindowKeys>> inside = exactKeys(exact, channels);
  std::vector<Track> tracks;
  tracks.reserve(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    tracks.push_back(buildTrack(exact, channels[i], inside[i]));
  }
  return tracks;
}

} // namespace stretch::rig

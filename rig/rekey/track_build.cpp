#include "rig/rekey/track_build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

constexpr double sameKey = 2e-5;

// A key before it is written: tangents only count on cubic splines.
struct Key {
  float time = 0.0F;
  Vec4 value{0.0};
  Vec4 inTangent{0.0};
  Vec4 outTangent{0.0};
  std::optional<std::size_t> sourceKey; // written from the source's own numbers
};

std::size_t widthOf(Channel channel) {
  return channel == Channel::rotation ? 4 : 3;
}

Vec4 numbersAt(const Track& track, std::size_t offset) {
  Vec4 value(0.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(track.width); ++i) {
    value[i] = static_cast<double>(track.values[offset + i]);
  }
  return value;
}

Key keyOfSource(const Track& track, std::size_t index) {
  const auto width = static_cast<std::size_t>(track.width);
  Key key;
  key.time = track.times[index];
  key.sourceKey = index;
  if (track.interpolation == Interpolation::cubicSpline) {
    key.inTangent = numbersAt(track, 3 * index * width);
    key.value = numbersAt(track, (3 * index + 1) * width);
    key.outTangent = numbersAt(track, (3 * index + 2) * width);
  } else {
    key.value = numbersAt(track, index * width);
  }
  return key;
}

// The source's value and slope between its keys, in the arc that its own interpolation takes.
class SourceCurve {
public:
  SourceCurve(ExactMotion& exact, const ChangedChannel& channel) : exact_(exact), channel_(channel) {}

  [[nodiscard]] Vec4 value(double time) const {
    return channelValue(exact_.sourceAt(time), channel_.node, channel_.channel);
  }

  [[nodiscard]] Vec4 slope(double time, int side) const {
    const double step = 1e-4;
    const double before = side > 0 ? time : time - step;
    const double after = side < 0 ? time : time + step;
    const Vec4 a = value(before);
    Vec4 b = value(after);
    if (channel_.channel == Channel::rotation && glm::dot(a, b) < 0.0) {
      b = -b;
    }
    return (b - a) / (after - before);
  }

private:
  ExactMotion& exact_;
  const ChangedChannel& channel_;
};

bool insideAny(const std::vector<Window>& windows, double time) {
  return std::any_of(windows.begin(), windows.end(), [&](const Window& window) {
    return time >= window.startSeconds - sameKey && time <= window.endSeconds + sameKey;
  });
}

float justBefore(float time) {
  return std::nextafter(time, -std::numeric_limits<float>::infinity());
}
float justAfter(float time) {
  return std::nextafter(time, std::numeric_limits<float>::infinity());
}

bool isCubic(const ChangedChannel& channel) {
  return channel.source != nullptr && channel.source->interpolation == Interpolation::cubicSpline;
}

// Keys of the source outside the windows. Where the source steps there, each step becomes a pair of
// neighbouring keys.
void addOutsideKeys(const ChannelKeys& keys, std::vector<Key>& out) {
  const Track* source = keys.channel.source;
  if (source == nullptr) {
    return;
  }
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

Key exactKey(ExactMotion& exact, const ChangedChannel& channel, double time) {
  Key key;
  key.time = static_cast<float>(time);
  key.value = channelValue(exact.at(time).pose, channel.node, channel.channel);
  if (isCubic(channel)) {
    key.inTangent = slopeOf(exact, channel, time, -1);
    key.outTangent = slopeOf(exact, channel, time, 1);
  }
  return key;
}

// At the border of a window the curve outside is the source's: its tangent there, and its own numbers where
// it has a key.
void joinSource(const ChannelKeys& keys, const SourceCurve& curve, double time, int outside, Key& key) {
  const Track* source = keys.channel.source;
  if (isCubic(keys.channel)) {
    (outside < 0 ? key.inTangent : key.outTangent) = curve.slope(time, outside);
  }
  if (source == nullptr) {
    return;
  }
  const auto found = std::find(source->times.begin(), source->times.end(), key.time);
  if (found == source->times.end()) {
    return;
  }
  const Key original = keyOfSource(*source, static_cast<std::size_t>(found - source->times.begin()));
  constexpr double rounding = 1e-6;
  if (glm::length(original.value - key.value) < rounding * (1.0 + glm::length(key.value))) {
    key.value = original.value;
    if (!isCubic(keys.channel)) {
      key.sourceKey = original.sourceKey;
    }
  }
  if (isCubic(keys.channel)) {
    (outside < 0 ? key.inTangent : key.outTangent) = outside < 0 ? original.inTangent : original.outTangent;
  }
}

Key sourceValueKey(const SourceCurve& curve, float time, bool cubic) {
  Key key;
  key.time = time;
  key.value = curve.value(static_cast<double>(time));
  if (cubic) {
    key.inTangent = curve.slope(static_cast<double>(time), -1);
    key.outTangent = curve.slope(static_cast<double>(time), 1);
  }
  return key;
}

void addWindowKeys(ExactMotion& exact, const ChannelKeys& keys, std::size_t index, std::vector<Key>& out) {
  const Window& window = keys.windows[index];
  const SourceCurve curve(exact, keys.channel);
  const bool cubic = isCubic(keys.channel);
  if (window.jumpsBefore) {
    out.push_back(sourceValueKey(curve, justBefore(static_cast<float>(window.startSeconds)), cubic));
  }
  for (const double time : keys.times[index]) {
    Key key = exactKey(exact, keys.channel, time);
    if (time == window.startSeconds && !window.jumpsBefore) {
      joinSource(keys, curve, time, -1, key);
    }
    if (time == window.endSeconds && !window.jumpsAfter) {
      joinSource(keys, curve, time, 1, key);
    }
    out.push_back(key);
  }
  if (window.jumpsAfter) {
    out.push_back(sourceValueKey(curve, justAfter(static_cast<float>(window.endSeconds)), cubic));
  }
}

// A cubic rotation cut in two is no longer the same curve once its new key is a unit quaternion: further keys
// between the cut and the source's next key keep it within `tolerance`.
void addCubicJoints(const SourceCurve& curve, double start, double end, int depth, std::vector<Key>& out) {
  const double h = end - start;
  const double middle = 0.5 * (start + end);
  const Vec4 a = curve.value(start);
  Vec4 b = curve.value(end);
  Vec4 wanted = curve.value(middle);
  b = glm::dot(a, b) < 0.0 ? -b : b;
  wanted = glm::dot(a, wanted) < 0.0 ? -wanted : wanted;
  const Vec4 hermite = 0.5 * (a + b) + (curve.slope(start, 1) - curve.slope(end, -1)) * (h / 8.0);
  constexpr double tolerance = 1e-7;
  if (depth == 0 || glm::length(glm::normalize(hermite) - wanted) < tolerance) {
    return;
  }
  addCubicJoints(curve, start, middle, depth - 1, out);
  out.push_back(sourceValueKey(curve, static_cast<float>(middle), true));
  addCubicJoints(curve, middle, end, depth - 1, out);
}

void joinCubicRotations(ExactMotion& exact, const ChannelKeys& keys, std::vector<Key>& out) {
  if (!isCubic(keys.channel) || keys.channel.channel != Channel::rotation) {
    return;
  }
  const SourceCurve curve(exact, keys.channel);
  const std::vector<float>& times = keys.channel.source->times;
  constexpr int deepest = 5;
  for (const Window& window : keys.windows) {
    const auto start = static_cast<float>(window.startSeconds);
    const auto end = static_cast<float>(window.endSeconds);
    const auto before = std::lower_bound(times.begin(), times.end(), start);
    const auto after = std::upper_bound(times.begin(), times.end(), end);
    if (before != times.begin() && before != times.end() && *before != start) {
      addCubicJoints(curve, static_cast<double>(*(before - 1)), window.startSeconds, deepest, out);
    }
    if (after != times.begin() && after != times.end() && *(after - 1) != end) {
      addCubicJoints(curve, window.endSeconds, static_cast<double>(*after), deepest, out);
    }
  }
}

void sortUnique(std::vector<Key>& keys) {
  std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.time < b.time; });
  keys.erase(
      std::unique(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.time == b.time; }),
      keys.end());
}

// Readers that lerp quaternions without looking at signs get neighbouring ones; keys of the source keep
// theirs.
void alignHemispheres(std::vector<Key>& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Key* neighbour = i > 0 ? &keys[i - 1] : (keys.size() > 1 ? &keys[1] : nullptr);
    if (!keys[i].sourceKey && neighbour != nullptr && glm::dot(keys[i].value, neighbour->value) < 0.0) {
      keys[i].value = -keys[i].value;
      keys[i].inTangent = -keys[i].inTangent;
      keys[i].outTangent = -keys[i].outTangent;
    }
  }
}

void append(const Vec4& numbers, std::size_t width, std::vector<float>& out) {
  for (std::size_t i = 0; i < width; ++i) {
    out.push_back(static_cast<float>(numbers[i]));
  }
}

} // namespace

Track buildTrack(ExactMotion& exact, const ChannelKeys& keys) {
  std::vector<Key> all;
  for (std::size_t i = 0; i < keys.windows.size(); ++i) {
    addWindowKeys(exact, keys, i, all);
  }
  joinCubicRotations(exact, keys, all);
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
  track.interpolation = isCubic(keys.channel) ? Interpolation::cubicSpline : Interpolation::linear;
  const std::size_t width = widthOf(track.channel);
  for (const Key& key : all) {
    track.times.push_back(key.time);
    if (isCubic(keys.channel)) {
      append(key.inTangent, width, track.values);
    }
    append(key.value, width, track.values);
    if (isCubic(keys.channel)) {
      append(key.outTangent, width, track.values);
    }
  }
  return track;
}

} // namespace stretch::rig

#include "app/edits/keys/track_row.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/math/euler.h"
#include "core/math/rotation.h"

namespace stretch::app {

namespace {

constexpr double degrees = 180.0 / pi;
constexpr double farFuture = 1e7; // frames

// What a track stores for one key: of a cubic one the tangents for each second.
struct StoredKey {
  std::array<double, 4> value{};
  std::array<double, 4> inTangent{};
  std::array<double, 4> outTangent{};
};

std::size_t widthOf(const Track& track) {
  return static_cast<std::size_t>(track.width);
}

StoredKey storedKey(const Track& track, std::size_t key) {
  StoredKey stored;
  const std::size_t width = widthOf(track);
  const bool cubic = track.interpolation == Interpolation::cubicSpline;
  const std::size_t at = cubic ? (3 * key + 1) * width : key * width;
  for (std::size_t i = 0; i < width; ++i) {
    stored.value[i] = static_cast<double>(track.values[at + i]);
    if (cubic) {
      stored.inTangent[i] = static_cast<double>(track.values[at - width + i]);
      stored.outTangent[i] = static_cast<double>(track.values[at + width + i]);
    }
  }
  return stored;
}

Quat quatOf(const std::array<double, 4>& xyzw) {
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

std::array<double, 4> numbersOf(const Quat& q) {
  return {q.x, q.y, q.z, q.w};
}

Quat unitOf(const std::array<double, 4>& xyzw) {
  const Quat q = quatOf(xyzw);
  const double length = glm::length(q);
  return length > 1e-12 ? q / length : Quat(1.0, 0.0, 0.0, 0.0);
}

Vec3 anglesOf(const KeyValues& values) {
  return Vec3(values[0], values[1], values[2]) / degrees;
}

KeyValues shown(const Vec3& value) {
  return {value.x, value.y, value.z, 0.0, 0.0, 0.0};
}

KeyValues shownValue(const Track& track, const std::array<double, 4>& value, const KeyValues& near) {
  if (track.channel != Channel::rotation) {
    return {value[0], value[1], value[2], 0.0, 0.0, 0.0};
  }
  return shown(eulerNear(unitOf(value), anglesOf(near)) * degrees);
}

// The shown angles at a key, followed from those of the key before, so that a curve has no jump.
KeyValues followed(const Track& track, std::size_t key, const KeyValues& before) {
  if (key == 0 || track.channel != Channel::rotation || track.interpolation == Interpolation::step) {
    return shownValue(track, storedKey(track, key).value, before);
  }
  const Quat from = unitOf(storedKey(track, key - 1).value);
  const Quat to = unitOf(storedKey(track, key).value);
  constexpr double step = 0.25;
  const double angle = angleBetween(from, to);
  const bool cubic = track.interpolation == Interpolation::cubicSpline;
  const int steps = std::clamp(static_cast<int>(angle / step), cubic ? 2 : 1, 16);
  const auto start = static_cast<double>(track.times[key - 1]);
  const auto end = static_cast<double>(track.times[key]);
  KeyValues values = before;
  for (int i = 1; i < steps; ++i) {
    values = trackValues(track, start + (end - start) * i / steps, values);
  }
  return shownValue(track, storedKey(track, key).value, values);
}

KeyValues shownSlope(const Track& track, const StoredKey& key, const std::array<double, 4>& tangent,
                     const KeyValues& values, double framesPerSecond) {
  if (track.channel != Channel::rotation) {
    return shown(Vec3(tangent[0], tangent[1], tangent[2]) / framesPerSecond);
  }
  return shown(eulerRate(quatOf(key.value), quatOf(tangent), anglesOf(values)) * degrees / framesPerSecond);
}

// Straight to the neighbours.
void addSecants(std::vector<RowKey>& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto slope = [&](std::size_t a, std::size_t b) {
        return (keys[b].values[c] - keys[a].values[c]) / (keys[b].frame - keys[a].frame);
      };
      keys[i].inSlopes[c] = i > 0 ? slope(i - 1, i) : 0.0;
      keys[i].outSlopes[c] = i + 1 < keys.size() ? slope(i, i + 1) : 0.0;
    }
  }
}

void addCubicSlopes(const Track& track, double framesPerSecond, std::vector<RowKey>& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const StoredKey stored = storedKey(track, i);
    keys[i].inSlopes = shownSlope(track, stored, stored.inTangent, keys[i].values, framesPerSecond);
    keys[i].outSlopes = shownSlope(track, stored, stored.outTangent, keys[i].values, framesPerSecond);
  }
}

rig::KeyInterpolation kindOf(Interpolation interpolation) {
  return interpolation == Interpolation::step     ? rig::KeyInterpolation::stepped
         : interpolation == Interpolation::linear ? rig::KeyInterpolation::linear
                                                  : rig::KeyInterpolation::free;
}

// The turn from one rotation to the next as a rate of the quaternion at `q`, the shorter way.
Quat turningRate(const Quat& q, const Quat& from, Quat to, double seconds) {
  to = glm::dot(from, to) < 0.0 ? -to : to;
  const Quat difference = glm::normalize(glm::inverse(from) * to);
  const Vec3 axis(difference.x, difference.y, difference.z);
  const double sine = glm::length(axis);
  const double half = std::atan2(sine, difference.w);
  const Vec3 velocity = sine > 1e-12 ? axis * (half / sine / seconds) : Vec3(0.0);
  return q * Quat(0.0, velocity.x, velocity.y, velocity.z);
}

// Keys of a row on their way into a track.
class TrackWriter {
public:
  TrackWriter(const Track& before, const KeyedRow& row, double framesPerSecond)
      : before_(before), row_(row), rate_(framesPerSecond) {}

  [[nodiscard]] WrittenTrack track() {
    Track written = before_;
    written.interpolation = row_.interpolation;
    written.times.clear();
    written.values.clear();
    gather();
    if (row_.interpolation == Interpolation::cubicSpline) {
      for (std::size_t i = 0; i < stored_.size(); ++i) {
        setTangents(i);
      }
    }
    for (std::size_t i = 0; i < stored_.size(); ++i) {
      written.times.push_back(seconds_[i]);
      append(i, written.values);
    }
    std::vector<std::size_t> rowKeys;
    for (const RowKey* const key : keys_) {
      rowKeys.push_back(static_cast<std::size_t>(key - row_.keys.data()));
    }
    return {std::move(written), std::move(rowKeys)};
  }

private:
  [[nodiscard]] bool wasCubic() const { return before_.interpolation == Interpolation::cubicSpline; }
  [[nodiscard]] bool turns() const { return before_.channel == Channel::rotation; }

  float secondsOf(const RowKey& key) const {
    if (key.origin >= 0) {
      const float old = before_.times[at(key.origin)];
      if (static_cast<double>(old) * rate_ == key.frame) {
        return old;
      }
    }
    return static_cast<float>(key.frame / rate_);
  }

  std::array<double, 4> valueOf(const RowKey& key) const {
    const bool known = key.origin >= 0;
    const std::array<double, 4> old =
        known ? storedKey(before_, at(key.origin)).value : std::array<double, 4>{};
    if (known && !key.valuesChanged) {
      return old;
    }
    if (!turns()) {
      return {key.values[0], key.values[1], key.values[2], 0.0};
    }
    const Quat turned = rotationOf(anglesOf(key.values));
    const Quat near = known ? quatOf(old) : stored_.empty() ? turned : quatOf(stored_.back().value);
    return numbersOf(glm::dot(near, turned) < 0.0 ? -turned : turned);
  }

  void gather() {
    for (const RowKey& key : row_.keys) {
      const float seconds = secondsOf(key);
      if (!seconds_.empty() && !(seconds > seconds_.back())) {
        continue;
      }
      StoredKey stored;
      stored.value = valueOf(key);
      // A cubic spline is between the numbers as they stand: the same rotation must have the same sign.
      const bool joins = row_.interpolation == Interpolation::cubicSpline && !wasCubic() && turns();
      if (joins && !stored_.empty() && glm::dot(quatOf(stored.value), quatOf(stored_.back().value)) < 0.0) {
        stored.value = numbersOf(-quatOf(stored.value));
      }
      seconds_.push_back(seconds);
      stored_.push_back(stored);
      keys_.push_back(&key);
    }
  }

  // As the track ran before there were tangents: evenly to the neighbour.
  std::array<double, 4> evenTangent(std::size_t key, std::size_t other) const {
    const std::size_t from = std::min(key, other);
    const std::size_t to = std::max(key, other);
    const double seconds = static_cast<double>(seconds_[to]) - static_cast<double>(seconds_[from]);
    if (turns()) {
      return numbersOf(turningRate(unitOf(stored_[key].value), unitOf(stored_[from].value),
                                   unitOf(stored_[to].value), seconds));
    }
    std::array<double, 4> tangent{};
    for (std::size_t i = 0; i < 4; ++i) {
      tangent[i] = (stored_[to].value[i] - stored_[from].value[i]) / seconds;
    }
    return tangent;
  }

  std::array<double, 4> tangentOf(const KeyValues& slopes, const KeyValues& values,
                                  const std::array<double, 4>& stored) const {
    if (!turns()) {
      return {slopes[0] * rate_, slopes[1] * rate_, slopes[2] * rate_, 0.0};
    }
    const Quat rate = rotationRate(anglesOf(values), anglesOf(slopes) * rate_);
    const bool flipped = glm::dot(rotationOf(anglesOf(values)), quatOf(stored)) < 0.0;
    return numbersOf(flipped ? -rate : rate);
  }

  void setTangents(std::size_t i) {
    const RowKey& key = *keys_[i];
    StoredKey& stored = stored_[i];
    const bool turned = turns() && key.valuesChanged;
    if (key.origin >= 0 && !key.slopesChanged && !turned && wasCubic()) {
      const StoredKey old = storedKey(before_, at(key.origin));
      stored.inTangent = old.inTangent;
      stored.outTangent = old.outTangent;
    } else if (!key.slopesChanged && !wasCubic()) {
      stored.inTangent = i > 0 ? evenTangent(i, i - 1) : std::array<double, 4>{};
      stored.outTangent = i + 1 < stored_.size() ? evenTangent(i, i + 1) : std::array<double, 4>{};
    } else {
      stored.inTangent = tangentOf(key.inSlopes, key.values, stored.value);
      stored.outTangent = tangentOf(key.outSlopes, key.values, stored.value);
    }
  }

  void append(std::size_t i, std::vector<float>& values) const {
    const auto add = [&](const std::array<double, 4>& numbers) {
      for (std::size_t c = 0; c < widthOf(before_); ++c) {
        values.push_back(static_cast<float>(numbers[c]));
      }
    };
    const bool cubic = row_.interpolation == Interpolation::cubicSpline;
    if (cubic) {
      add(stored_[i].inTangent);
    }
    add(stored_[i].value);
    if (cubic) {
      add(stored_[i].outTangent);
    }
  }

  const Track& before_;
  const KeyedRow& row_;
  double rate_;
  std::vector<float> seconds_;
  std::vector<StoredKey> stored_;
  std::vector<const RowKey*> keys_;
};

} // namespace

KeyValues trackValues(const Track& track, double timeSeconds, const KeyValues& near) {
  std::array<double, 4> value{};
  sampleTrack(track, timeSeconds, value.data());
  return shownValue(track, value, near);
}

KeyedRow readTrack(const Track& track, double framesPerSecond, RowDetail detail) {
  KeyedRow row;
  row.row = {track.node, track.channel, {}};
  row.interpolation = track.interpolation;
  row.parts = {{0.0, farFuture}};
  row.keys.resize(track.times.size());
  KeyValues before{};
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    RowKey& key = row.keys[i];
    key.frame = static_cast<double>(track.times[i]) * framesPerSecond;
    key.kind = kindOf(track.interpolation);
    key.origin = static_cast<int>(i);
    key.valuesChanged = key.slopesChanged = false;
    if (detail == RowDetail::values) {
      key.values = before = followed(track, i, before);
    }
  }
  if (detail == RowDetail::values && track.interpolation == Interpolation::linear) {
    addSecants(row.keys);
  } else if (detail == RowDetail::values && track.interpolation == Interpolation::cubicSpline) {
    addCubicSlopes(track, framesPerSecond, row.keys);
  }
  return row;
}

WrittenTrack writeTrack(const Track& before, const KeyedRow& row, double framesPerSecond) {
  return TrackWriter(before, row, framesPerSecond).track();
}

} // namespace stretch::app

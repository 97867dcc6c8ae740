#include "rig/controllers/offset_curve.h"

#include <algorithm>
#include <cmath>

#include "core/anim/frames.h"
#include "core/anim/key_time.h"
#include "core/math/monotone_curve.h"

namespace stretch::rig {

namespace {

double hermite(double from, double outSlope, double to, double inSlope, double length, double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * from + (t3 - 2 * t2 + t) * length * outSlope + (3 * t2 - 2 * t3) * to +
         (t3 - t2) * length * inSlope;
}

std::array<double, 7> numbersOf(const Vec3& move, const Vec3& turn, double value) {
  return {move.x, move.y, move.z, turn.x, turn.y, turn.z, value};
}

Offset offsetOf(const std::array<double, 7>& numbers) {
  return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}, numbers[6]};
}

OffsetKey restingKey(double frame, double standard) {
  OffsetKey key;
  key.frame = frame;
  key.value = standard;
  return key;
}

// The keys, and what stands at the ends of the range.
std::vector<OffsetKey> withEnds(const Adjustment& adjustment, double standard) {
  std::vector<OffsetKey> keys = adjustment.keys;
  if (!adjustment.rangeFrames) {
    return keys;
  }
  for (const double end : {adjustment.rangeFrames->x, adjustment.rangeFrames->y}) {
    const bool stands =
        std::ranges::any_of(keys, [&](const OffsetKey& key) { return sameFrame(key.frame, end); });
    if (!stands) {
      keys.push_back(restingKey(end, standard));
    }
  }
  std::ranges::sort(keys, [](const OffsetKey& a, const OffsetKey& b) { return a.frame < b.frame; });
  return keys;
}

} // namespace

OffsetCurve::OffsetCurve(const Adjustment& adjustment, double standard, double framesPerSecond)
    : standard_(standard) {
  const std::vector<OffsetKey> keys = withEnds(adjustment, standard);
  for (const OffsetKey& key : keys) {
    keys_.push_back({key.frame / framesPerSecond,
                     numbersOf(key.move, key.turn, key.value),
                     {},
                     {},
                     key.interpolation == KeyInterpolation::stepped});
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Numbers given = numbersOf(keys[i].moveSlope * framesPerSecond, keys[i].turnSlope * framesPerSecond,
                                    keys[i].valueSlope * framesPerSecond);
    for (std::size_t number = 0; number < width; ++number) {
      keys_[i].inSlopes[number] = slopeAt(i, number, keys[i].interpolation, given[number], -1);
      keys_[i].outSlopes[number] = slopeAt(i, number, keys[i].interpolation, given[number], 1);
    }
  }
  if (adjustment.rangeFrames) {
    start_ = adjustment.rangeFrames->x / framesPerSecond;
    end_ = adjustment.rangeFrames->y / framesPerSecond;
  }
}

double OffsetCurve::slopeAt(std::size_t key, std::size_t number, KeyInterpolation interpolation, double given,
                            int side) const {
  const auto point = [&](std::size_t i) { return Vec2(keys_[i].timeSeconds, keys_[i].numbers[number]); };
  const bool hasBefore = key > 0;
  const bool hasAfter = key + 1 < keys_.size();
  if (interpolation == KeyInterpolation::free) {
    return given;
  }
  if (interpolation == KeyInterpolation::linear && (side < 0 ? hasBefore : hasAfter)) {
    const Vec2 piece = side < 0 ? point(key) - point(key - 1) : point(key + 1) - point(key);
    return piece.y / piece.x;
  }
  const bool smooth = interpolation == KeyInterpolation::automatic && hasBefore && hasAfter;
  return smooth ? monotoneSlope(point(key - 1), point(key), point(key + 1)) : 0.0;
}

OffsetCurve::Numbers OffsetCurve::rest() const {
  return numbersOf(Vec3(0.0), Vec3(0.0), standard_);
}

bool OffsetCurve::covers(double timeSeconds) const {
  const double rounding = keyTimeRounding(timeSeconds);
  return !keys_.empty() && timeSeconds >= start_ - rounding && timeSeconds <= end_ + rounding;
}

Offset OffsetCurve::at(double timeSeconds) const {
  if (!covers(timeSeconds)) {
    return offsetOf(rest());
  }
  const double rounded = timeSeconds + keyTimeRounding(timeSeconds);
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), rounded,
                                     [](double time, const Key& key) { return time < key.timeSeconds; });
  if (next == keys_.begin()) {
    return offsetOf(keys_.front().numbers);
  }
  const Key& before = *(next - 1);
  if (next == keys_.end() || before.holds || timeSeconds <= before.timeSeconds) {
    return offsetOf(before.numbers);
  }
  const double length = next->timeSeconds - before.timeSeconds;
  const double t = (timeSeconds - before.timeSeconds) / length;
  Numbers numbers{};
  for (std::size_t i = 0; i < width; ++i) {
    numbers[i] =
        hermite(before.numbers[i], before.outSlopes[i], next->numbers[i], next->inSlopes[i], length, t);
  }
  return offsetOf(numbers);
}

bool OffsetCurve::jumpsAtStart() const {
  return std::isfinite(start_) && !keys_.empty() && keys_.front().numbers != rest();
}

bool OffsetCurve::jumpsAtEnd() const {
  return std::isfinite(end_) && !keys_.empty() && keys_.back().numbers != rest();
}

std::vector<double> OffsetCurve::jumpSeconds() const {
  std::vector<double> seconds;
  for (std::size_t i = 1; i < keys_.size(); ++i) {
    if (keys_[i - 1].holds && keys_[i - 1].numbers != keys_[i].numbers) {
      seconds.push_back(keys_[i].timeSeconds);
    }
  }
  return seconds;
}

std::vector<double> OffsetCurve::keySeconds() const {
  std::vector<double> seconds;
  for (const Key& key : keys_) {
    seconds.push_back(key.timeSeconds);
  }
  return seconds;
}

} // namespace stretch::rig

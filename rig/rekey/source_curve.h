#pragma once

#include <optional>
#include <vector>

#include "rig/rekey/key_times.h"

namespace stretch::rig {

/// A key before it is written: tangents only count on cubic splines.
struct Key {
  float time = 0.0F;
  Vec4 value{0.0};
  Vec4 inTangent{0.0};
  Vec4 outTangent{0.0};
  std::optional<std::size_t> sourceKey; ///< Written from the source's own numbers.
};

/// The source's key with its own numbers.
[[nodiscard]] Key keyOfSource(const Track& track, std::size_t index);

/// The source's track as players see it, rotations of unit length; needs a source.
class SourceCurve {
public:
  explicit SourceCurve(const Track& track, double jointsPerSecond = 0.0)
      : track_(track), jointsPerSecond_(jointsPerSecond) {}

  [[nodiscard]] double jointsPerSecond() const { return jointsPerSecond_; }
  [[nodiscard]] Vec4 value(double timeSeconds) const;
  /// Per second; `side` -1 from before, +1 from after. Of a cubic spline exact, else 0.
  [[nodiscard]] Vec4 slope(double timeSeconds, int side) const;

  /// A key that cuts the curve at a time: the source's own numbers where it has a key within sameKey of it.
  [[nodiscard]] Key cutAt(float time) const;

  /// A cubic rotation cut in two is no longer the same curve once its new key is a unit quaternion. Adds the
  /// keys that keep it within 1e-7 between a key of the source and a cut, whichever comes first; with
  /// `jointsPerSecond` above 0 those alone that stand on so many even times a second.
  void addJoints(const Key& from, const Key& to, std::vector<Key>& out) const;

private:
  const Track& track_;
  double jointsPerSecond_ = 0.0;
};

} // namespace stretch::rig

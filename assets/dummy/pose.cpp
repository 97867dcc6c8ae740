#include "assets/dummy/pose.h"

#include <algorithm>

namespace stretch::assets {

namespace {

/// Slope of the curve at a key, per frame: the weighted harmonic mean of its neighbouring secants (Fritsch
/// and Butland), zero at extremes and at both ends.
double slopeAt(const std::vector<Pose>& poses, std::size_t key, std::size_t control, int axis) {
  if (key == 0 || key + 1 == poses.size()) {
    return 0.0;
  }
  const auto value = [&](std::size_t k) { return poses[k].values[control][axis]; };
  const double before = poses[key].frame - poses[key - 1].frame;
  const double after = poses[key + 1].frame - poses[key].frame;
  const double rise = (value(key) - value(key - 1)) / before;
  const double nextRise = (value(key + 1) - value(key)) / after;
  if (rise * nextRise <= 0.0) {
    return 0.0;
  }
  const double weight = 2.0 * after + before;
  const double nextWeight = after + 2.0 * before;
  return (weight + nextWeight) / (weight / rise + nextWeight / nextRise);
}

} // namespace

Pose poseAt(const std::vector<Pose>& poses, double frame) {
  std::size_t key = 0;
  while (key + 2 < poses.size() && frame >= poses[key + 1].frame) {
    ++key;
  }
  const Pose& from = poses[key];
  const Pose& to = poses[key + 1];
  const double length = to.frame - from.frame;
  const double t = std::clamp((frame - from.frame) / length, 0.0, 1.0);
  Pose pose;
  for (std::size_t control = 0; control < pose.values.size(); ++control) {
    for (int axis = 0; axis < 3; ++axis) {
      const double a = from.values[control][axis];
      const double b = to.values[control][axis];
      const double leaving = slopeAt(poses, key, control, axis) * length;
      const double arriving = slopeAt(poses, key + 1, control, axis) * length;
      const double t2 = t * t;
      const double t3 = t2 * t;
      pose.values[control][axis] = (2.0 * t3 - 3.0 * t2 + 1.0) * a + (t3 - 2.0 * t2 + t) * leaving +
                                   (3.0 * t2 - 2.0 * t3) * b + (t3 - t2) * arriving;
    }
  }
  return pose;
}

} // namespace stretch::assets

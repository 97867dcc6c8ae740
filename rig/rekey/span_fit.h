#pragma once

#include "rig/rekey/exact_motion.h"
#include "rig/rekey/key_times.h"

namespace stretch::rig {

/// One channel between two neighbouring keys, as the written track runs.
struct ChannelSpan {
  double startSeconds = 0.0;
  double endSeconds = 0.0;
  Vec4 start{0.0};
  Vec4 end{0.0}; ///< Rotations: on the hemisphere that the motion comes from `start` to.
  bool isCubic = false;
  Vec4 outTangent{0.0}; ///< At the start, per second; cubic only.
  Vec4 inTangent{0.0};  ///< At the end, per second; cubic only.

  /// Value at a time within the span; rotations as players interpolate them, not normalised when cubic.
  [[nodiscard]] Vec4 at(Channel channel, double timeSeconds) const;
};

/// The span that follows the exact motion: its values at the ends and, for a channel with tangents,
/// those tangents that bring the cubic nearest (least squares) to the motion between.
[[nodiscard]] ChannelSpan fitSpan(ExactMotion& exact, const ChangedChannel& channel, double startSeconds,
                                  double endSeconds);

/// Frames and half frames strictly inside a span: where a fit is judged.
[[nodiscard]] std::vector<double> checkTimes(double framesPerSecond, double startSeconds, double endSeconds);

} // namespace stretch::rig

#pragma once

#include <vector>

#include "rig/rekey/exact_motion.h"
#include "rig/rekey/rekey.h"

namespace stretch::rig {

/// Seconds: nearer than this to a key of the source is that key.
inline constexpr double sameKey = 2e-5;

/// A stretch of time that a trail changes. Both ends are exactly representable in single precision, as keys
/// are.
struct Window {
  double startSeconds = 0.0;
  double endSeconds = 0.0;
  bool jumpsBefore = false; ///< The motion is not the source's right before the start: a release of no length
                            ///< (pivot at end).
  bool jumpsAfter = false;  ///< The same after the end.
};

/// A property that a trail changes.
struct ChangedChannel {
  int node = -1;
  Channel channel = Channel::translation;
  const Track* source = nullptr; ///< Null when the clip does not animate it.
  bool isCubic = false;          ///< Its keys get tangents: as the source, else as the others of the limb.
};

/// One trail's part in the new keys.
struct TrailKeys {
  const SolvedTrail* trail = nullptr;
  std::vector<Window> windows; ///< Usually one; two where a loop wraps. Disjoint, ascending.
  std::vector<ChangedChannel> channels;
  std::vector<int> stretchedNodes;
  std::vector<std::vector<double>> times;        ///< Key times of each window, ascending, its ends included.
  std::vector<std::vector<double>> stretchTimes; ///< The same for the stretch of the bones, which runs
                                                 ///< straight.
};

/// Chooses where one trail's limb gets keys.
[[nodiscard]] TrailKeys chooseKeys(ExactMotion& exact, const SolvedTrail& trail, const RekeyOptions& options);

/// Time as a key stores it.
[[nodiscard]] inline double asKeyTime(double timeSeconds) {
  return static_cast<double>(static_cast<float>(timeSeconds));
}

} // namespace stretch::rig

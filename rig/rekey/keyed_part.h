#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Seconds: nearer than this to a key of the source is that key.
inline constexpr double sameKey = 2e-5;

/// Time as a key stores it.
[[nodiscard]] inline double asKeyTime(double timeSeconds) {
  return static_cast<double>(static_cast<float>(timeSeconds));
}

/// A stretch of time that is keyed anew. Both ends are exactly representable in single precision, as keys
/// are.
struct Window {
  double startSeconds = 0.0;
  double endSeconds = 0.0;
  bool jumpsBefore = false; ///< The motion is not the source's right before the start: a release of no length
                            ///< (pivot at end).
  bool jumpsAfter = false;  ///< The same after the end.
};

/// What one active trail, or the weight of one limb, moves and when.
struct KeyedPart {
  std::vector<int> nodes;         ///< Whose local transforms may change.
  double boneLength = 0.0;        ///< Of the limb on average, world units.
  std::vector<Window> windows;    ///< Usually one; two where a loop wraps. Disjoint, ascending.
  std::vector<double> keySeconds; ///< Times inside that get a key in any case: the ends of the range.
};

/// All parts of a motion.
[[nodiscard]] std::vector<KeyedPart> keyedParts(const MotionState& motion);

} // namespace stretch::rig

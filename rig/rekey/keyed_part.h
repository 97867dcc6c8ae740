#pragma once

#include <vector>

#include "core/anim/key_time.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Seconds: nearer than this to a key of the source is that key.
inline constexpr double sameKey = 2e-5;

/// A stretch of time that is keyed anew. Both ends are exactly representable in single precision, as keys
/// are.
struct Window {
  double startSeconds = 0.0;
  double endSeconds = 0.0;
  bool jumpsBefore = false; ///< The motion is not the source's right before the start: a release of no length
                            ///< (pivot at end).
  bool jumpsAfter = false;  ///< Whether it jumps after the end.
};

/// Lets a window reach to the end of one that begins no earlier and inside it. Where both begin or end at one
/// time it jumps there if one of them does.
void extend(Window& window, const Window& by);

/// Right beside a border where the motion jumps, but far enough to be on the other side of it: before it for
/// a direction of -1, after it for 1.
[[nodiscard]] double besideJump(double borderSeconds, double direction);

/// A jump of the motion inside a window gets two keys: one on the side where the time itself lies, and one
/// right beside it.
struct JumpInside {
  double insideSeconds = 0.0;
  double besideSeconds = 0.0; ///< See besideJump.
};

/// Nodes that adjustments, one active trail, holds, or the weight of one limb move, and when.
struct KeyedPart {
  std::vector<NodeIndex> nodes;   ///< Nodes whose local transforms may change.
  double boneLength = 0.0;        ///< Mean length of the limb's bones, world units.
  std::vector<Window> windows;    ///< Usually one; two where a loop wraps. Disjoint, ascending.
  std::vector<double> keySeconds; ///< Times inside that get a key in any case: the ends of the range.
  std::vector<JumpInside> jumps = {};
};

/// All parts of a motion.
[[nodiscard]] std::vector<KeyedPart> keyedParts(const MotionState& motion);

} // namespace stretch::rig

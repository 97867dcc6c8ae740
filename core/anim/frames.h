#pragma once

#include <cmath>

#include "core/anim/clip.h"

namespace stretch {

// Frames as real numbers in a clip's own rate. They come from times in seconds, which files store in single
// precision, so that a whole frame is met nearly and not exactly.

/// Two frames that differ by less are one.
inline constexpr double frameTolerance = 1e-3;

[[nodiscard]] inline bool sameFrame(double a, double b) {
  return std::abs(a - b) < frameTolerance;
}

/// Whether a frame lies between two others, or is one of them.
[[nodiscard]] inline bool isWithinFrames(double first, double last, double frame) {
  return frame > first - frameTolerance && frame < last + frameTolerance;
}

/// Returns the last whole frame that is not after a frame.
[[nodiscard]] inline double wholeFrameAtMost(double frame) {
  return std::floor(frame + frameTolerance);
}

/// Returns the first whole frame that is not before a frame.
[[nodiscard]] inline double wholeFrameAtLeast(double frame) {
  return std::ceil(frame - frameTolerance);
}

/// Returns the frame of the clip's last key: between two whole frames where the key is.
[[nodiscard]] inline double endInFrames(const Clip& clip) {
  return clip.endSeconds * clip.framesPerSecond;
}

/// Returns the last of the clip's frames, 0 or more: the whole frame nearest to its last key.
[[nodiscard]] inline double lastFrame(const Clip& clip) {
  return std::fmax(0.0, static_cast<double>(frameCount(clip) - 1));
}

} // namespace stretch

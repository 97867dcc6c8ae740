#pragma once

#include <string>
#include <vector>

#include "rig/adjust/frame_table.h"
#include "rig/motion/motion.h"
#include "rig/motion/solve.h"

namespace stretch::rig {

// The steps of solveMotion on one trail, in this order; each fills in members of `solved` from those before.

/// Nobody exaggerates an hour in one go; a broken file may claim to last for years. Frames.
inline constexpr double longestFrames = 100000.0;

/// Null when there is none, or one without a joint.
[[nodiscard]] const Limb* limbOf(const MotionInput& input, const std::string& id);

/// Nodes that sampling the path of a limb looks at.
[[nodiscard]] std::vector<NodeIndex> pathNodes(const MotionInput& input, const Limb& limb);

/// `used`: settings whose range lies within the clip.
[[nodiscard]] PathKey pathKeyOf(const std::string& limb, const TrailSettings& used);

/// Times at which the path is looked at, and of its keys; taken over where MotionInput::sameClip has them.
[[nodiscard]] PathTimes pathTimes(const MotionInput& input, const Limb& limb, const PathKey& key);

/// The original path over the range, of the adjusted clip, with its ratios, and the plane in which the limb
/// bends. `frames`: of pathNodes at least. Of `input` it looks at the ground alone, not at the trails.
[[nodiscard]] OriginalPath samplePath(const MotionInput& input, const Limb& limb, const PathKey& key,
                                      FrameSource& frames);

/// The tip (docs/exaggeration.md, The tip), and in words what is odd about it.
void solveTipOf(SolvedTrail& solved);
void explainTip(SolvedTrail& solved, double framesPerSecond);

/// Frames of the control spheres: the user's, or chosen.
void setControlFrames(SolvedTrail& solved);

/// Release and window. The keys of the limb's joints and its end say how long a release lasts that the user
/// left open.
void setRelease(const MotionInput& input, SolvedTrail& solved);

} // namespace stretch::rig

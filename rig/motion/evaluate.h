#pragma once

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// The clip at a time, past its last key held: every track is, and so is what trails and weight make of it.
[[nodiscard]] FrameState sampledFrame(const Scene& scene, const Clip& clip, double timeSeconds);

/// Brings every active trail onto a sampled frame, from the root outwards.
void applyTrails(const Scene& scene, const MotionState& motion, FrameState& frame);

/// The character at one time: the clip sampled, its trails (applyTrails) and its weight (applyWeight)
/// applied. Each stage takes the pose of the one before, with its stretch for each bone, and gives the next.
[[nodiscard]] FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                                        double timeSeconds);

} // namespace stretch::rig

#pragma once

#include <cstddef>
#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/apply_holds.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

// The stages of a frame are named here and in evaluate.cpp alone, in the order in which they act: the clip,
// adjustments, trails, holds, weight, what is held once more.

/// The clip at a time, past its last key held: every track is, and so is what trails and weight make of it.
[[nodiscard]] FrameState sampledFrame(const Scene& scene, const Clip& clip, double timeSeconds);

/// Returns the frame with the adjustments of the clip, from which trails start.
[[nodiscard]] FrameState adjustedFrame(const Scene& scene, const Clip& clip, const MotionState& motion,
                                       double timeSeconds);

/// Brings the trails onto an adjusted frame, every active one from the root outwards, and then the holds.
/// Answers what is held.
std::vector<HeldGoal> applyTrailsAndHolds(const Scene& scene, const MotionState& motion, FrameState& frame);

/// Brings what acts after the holds onto a frame: the weight of limbs, from which what is held comes back
/// (keep_held.h). `goals`: what was held; they come along with what holds them.
void applyAfterHolds(const Scene& scene, const MotionState& motion, std::vector<HeldGoal>& goals,
                     FrameState& frame);

/// Brings everything that acts on an adjusted frame onto it: these two, one after the other.
void applyMotion(const Scene& scene, const MotionState& motion, FrameState& frame);

/// The character at one time: the clip sampled and adjusted, and its motion (applyMotion) applied. Each stage
/// takes the pose of the one before, with its stretch for each bone, and gives the next.
[[nodiscard]] FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                                        double timeSeconds);

/// Brings one trail, by its place in MotionState::trails, onto a frame that the trails before it were applied
/// to, from the root outwards. `source`: the adjusted clip at the frame's time. Only the nodes that the trail
/// touches (touchedNodes), the hips, and the ancestors of these need to be filled in.
void applyTrail(const Scene& scene, const MotionState& motion, std::size_t trail, const FrameState& source,
                FrameState& frame);

/// A trail's two paths at the time of a frame that the trails before it were applied to, world space.
struct PathPoint {
  Vec3 original{0.0};
  Vec3 exaggerated{0.0};
};

/// Needs of `source` and `frame` what applyTrail needs.
[[nodiscard]] PathPoint pathPoint(const Scene& scene, const MotionState& motion, std::size_t trail,
                                  const FrameState& source, const FrameState& frame);

} // namespace stretch::rig

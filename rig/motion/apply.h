#pragma once

#include <cstddef>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Brings one trail, by its place in MotionState::trails, onto a frame that the trails before it were applied
/// to, from the root outwards. `source`: the source clip at the frame's time. Only the nodes that the trail
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

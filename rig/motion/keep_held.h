#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/apply_holds.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Brings what was held back to where it is held, on a frame that weight was applied to after the holds: an
/// end by the strength of its hold to where the hold left it, seen from the world, from its leader or from
/// its prop, and a prop to where its hands now have it (docs/holds.md, When). `before`: what the holds left.
/// `goals`: what applyHolds answered; those of leaders and props come along with them. What weight did not
/// move stays as it is, bit for bit.
void keepHeld(const Scene& scene, const MotionState& motion, const FrameState& before,
              std::vector<HeldGoal>& goals, FrameState& frame);

} // namespace stretch::rig

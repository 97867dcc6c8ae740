#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "rig/adjust/frame_table.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Finds where a limb's end rests in a clip: it keeps its place for 0.15 seconds and more. `frames` are asked
/// for the limb at the whole frames of `rangeSeconds`, which is cut to the clip.
[[nodiscard]] std::vector<Rest> restsIn(const Clip& clip, const Limb& limb, const Vec2& rangeSeconds,
                                        FrameSource& frames);

/// A target at one time, world space.
struct StoppedReach {
  Vec3 base{0.0};     ///< The limb's base.
  Vec3 original{0.0}; ///< The limb's end without the trail.
  Vec3 wanted{0.0};   ///< End with it, as if nothing were in the way.
  double timeSeconds = 0.0;
};

/// Returns the place that the limb's end comes to with the trail's stop plane in its way
/// (docs/exaggeration.md, The target).
[[nodiscard]] Vec3 stoppedTarget(const SolvedTrail& solved, const StoppedReach& reach);

/// Whether the limb comes to rest at its stop plane on the way back from the tip: its end touches the plane
/// no earlier than in the clip. Looks at the window and the rests.
[[nodiscard]] bool comesToRest(const SolvedTrail& solved);

} // namespace stretch::rig

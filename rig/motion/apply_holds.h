#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Place that a hold wants for the end of a limb at a time.
struct HeldGoal {
  HoldKind kind = HoldKind::pin;
  std::size_t index = 0; ///< In the list of its kind in SolvedHolds.
  std::size_t limb = 0;  ///< In SolvedHolds::limbs.
  Vec3 wanted{0.0};
  double strength = 1.0;                               ///< 1: fully held.
  std::optional<HoldKind> overriddenBy = std::nullopt; ///< The last hold after it that has the same limb.
};

/// Brings what is held to where it is held, on a frame that the trails were applied to: pins, then grips,
/// each after the one that moves its leader, then props with their hands (docs/holds.md). `source`: the
/// adjusted clip at the frame's time. Only SolvedHolds::nodes and their ancestors need to be filled in.
/// Answers what is held at that time, in this order; of a limb that several hold, the last has it.
std::vector<HeldGoal> applyHolds(const Scene& scene, const MotionState& motion, const FrameState& source,
                                 FrameState& frame);

} // namespace stretch::rig

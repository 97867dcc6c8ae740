#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "rig/limb.h"

namespace stretch::rig {

/// Position of the limb's end in world space.
[[nodiscard]] Vec3 endPosition(const Limb& limb, const std::vector<Mat4>& worlds);

/// Positions of the limb's joints, base first, and of its end: one more than Limb::joints.
[[nodiscard]] std::vector<Vec3> limbPoints(const Limb& limb, const std::vector<Mat4>& worlds);

/// The same in a frame whose limbs may be stretched: an estimated end moves with the stretch of the bone that
/// it ends.
[[nodiscard]] Vec3 endPosition(const Limb& limb, const FrameState& frame);
[[nodiscard]] std::vector<Vec3> limbPoints(const Limb& limb, const FrameState& frame);

/// Straight distance from the limb's base to its end in a frame.
[[nodiscard]] double limbLength(const Limb& limb, const FrameState& frame);

} // namespace stretch::rig

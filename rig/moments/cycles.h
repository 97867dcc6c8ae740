#pragma once

#include <cstddef>
#include <vector>

#include "rig/moments/body_motion.h"

namespace stretch::rig {

/// For each limb whether it goes round and round in a clip that closes, the limb being at the clip's end
/// where it is at its beginning, or as near as it goes in two frames: it does the same a half, a third or a
/// quarter of the clip later, or what its counterpart on the other side does, mirrored or not, half of the
/// clip later, or mirrored a quarter later; a leg, which may limp, nearly what its counterpart does three or
/// five eighths of it later; or each of four legs and more nearly what its counterpart does any part later,
/// which is a gallop. A limb in the middle is its own counterpart. Legs of one body go together.
/// `motion` holds the motion of `limbs`.
[[nodiscard]] std::vector<bool> limbsInCycles(const BodyMotion& motion, const std::vector<Limb>& limbs);

} // namespace stretch::rig

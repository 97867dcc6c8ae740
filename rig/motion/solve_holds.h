#pragma once

#include "rig/motion/motion.h"
#include "rig/motion/solve.h"

namespace stretch::rig {

/// Lets MotionInput::holds act on top of the trails of a motion that was solved from the same input.
void setHolds(const MotionInput& input, MotionState& motion);

/// The node of a prop, by its name or "#index"; none where there is no such node.
[[nodiscard]] NodeIndex propNode(const Scene& scene, const std::string& name);

} // namespace stretch::rig

#pragma once

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// Whether the plane where the trail stops is in the way of the limb's end at the tip. A trail may have a
/// plane that its limb never reaches. `solved`: of that motion.
[[nodiscard]] bool isStoppedAtTip(const Document& document, const rig::MotionState& motion,
                                  const rig::SolvedTrail& solved);

} // namespace stretch::app

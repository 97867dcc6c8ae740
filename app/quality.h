#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion.h"

namespace stretch::app {

/// What an animator would stumble over when playing an active trail, one line each with its frames: the
/// limb's length over the source's outside [min(1, S) / 1.5, 1.5 max(1, S)], or a vertex farther from its
/// source place than 1.5 times the tip's displacement. Looked at on every frame of range and release.
[[nodiscard]] std::vector<std::string>
motionWarnings(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail);

} // namespace stretch::app

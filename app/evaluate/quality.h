#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// The mesh costs far more than the limb alone.
enum class LookAt { limb, limbAndMesh };

/// What an animator would stumble over when playing an active trail, one line each with its frames, the worst
/// value and what to do about it: the limb's length over the source's outside [min(1, S) / 1.5, 1.5 max(1,
/// S)], the limb pointing more than 120 degrees away from where it did, or a vertex farther from its source
/// place than 1.5 times the tip's displacement. Looked at on every frame of range and release. Another range,
/// space or scale is advised only where it was tried and keeps the limb within these bounds.
[[nodiscard]] std::vector<std::string> motionWarnings(const Document& document,
                                                      const rig::MotionState& motion,
                                                      const rig::SolvedTrail& trail,
                                                      LookAt what = LookAt::limbAndMesh);

} // namespace stretch::app

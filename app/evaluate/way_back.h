#pragma once

#include <optional>
#include <string>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// Whether the clip's last pose is its first again: played as a loop it has no jump.
[[nodiscard]] bool endsMeet(const Document& document, int clip);

/// Fault in a limb's way back to the clip's own motion.
struct WayBackProblem {
  std::string what;       ///< "the way back is cut to 1 frame by the clip's end, ..."
  bool loopHelps = false; ///< Marking the clip as a loop mends it, for its ends meet.
};

/// Nothing where an active trail comes back in peace: its release is cut by the clip, or by its range
/// that begins again on a loop, and takes the limb back faster than it came, or not at all on a clip that can
/// be played as a loop.
[[nodiscard]] std::optional<WayBackProblem>
wayBackProblem(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail);

} // namespace stretch::app

#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// A hand or a foot that turns over between two half frames while a hold comes or goes, since it is turned by
/// half a turn there against how the hold has it: by the shortest turn lies one way round before and the
/// other way after.
struct EndFlip {
  rig::HoldKind kind = rig::HoldKind::pin;
  std::string limb;
  double frame = 0.0;   ///< Half frame right after the worst flip.
  double degrees = 0.0; ///< How far the end turns there.
};

/// One for each limb whose end flips where a hold has a part of it: it turns by more than three times what it
/// turns by without holds and what its leader turns by, and 45 degrees. `motion`: of the clip, with its
/// holds.
[[nodiscard]] std::vector<EndFlip> endFlips(const Document& document, const rig::MotionState& motion);

/// One line with the way out.
[[nodiscard]] std::string endFlipWarning(const EndFlip& flip);

} // namespace stretch::app

#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// A prop in two hands that turns over between two half frames, since the hands are turned against each other
/// by half a turn: between them lies one way round before and the other way after.
struct PropFlip {
  std::string prop;     ///< Name of its node; "#index" where it has none.
  double frame = 0.0;   ///< Half frame right after the worst flip.
  double degrees = 0.0; ///< How far it turns there.
};

/// One for each prop that flips: it turns by more than three times what its hands turn by, and 45 degrees.
/// `motion`: of the clip, with its holds.
[[nodiscard]] std::vector<PropFlip> propFlips(const Document& document, const rig::MotionState& motion);

/// One line with the way out.
[[nodiscard]] std::string flipWarning(const PropFlip& flip);

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

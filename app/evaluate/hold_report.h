#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// How well one end of a limb was held over the range of a hold, at its frames and between them.
struct HoldReport {
  rig::HoldKind kind = rig::HoldKind::pin;
  std::size_t index = 0; ///< In the list of its kind among the holds of the clip.
  std::string limb;
  double farthest = 0.0;               ///< From where it is held, world units.
  std::vector<double> framesFallShort; ///< Frames at which it is farther than a thousandth of the height.
};

/// Frames and half frames of the clip, at most some twenty thousand frames: where holds are looked at.
[[nodiscard]] std::vector<double> halfFramesOf(const rig::MotionState& motion);

/// One for each limb that a hold of the clip fully holds at any time. `motion`: of the clip, with its holds.
[[nodiscard]] std::vector<HoldReport> holdReports(const Document& document, const rig::MotionState& motion);

/// One line for a hold that falls short: "the pin of left-arm falls short at frames 5 to 9 by up to 0.12".
/// Empty where it does not.
[[nodiscard]] std::string holdWarning(const HoldReport& report);

/// "pin", "grip", "prop".
[[nodiscard]] const char* holdWord(rig::HoldKind kind);

} // namespace stretch::app

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
  double farthest = 0.0;                    ///< From where it is held, world units.
  std::vector<double> framesFallShort = {}; ///< Frames at which it is farther than a thousandth of the
                                            ///< height.
  double strength = 0.0;           ///< The most that it is held by, 0..1; below 1 it is held nowhere fully.
  double farthestOverridden = 0.0; ///< Likewise where another hold of the limb decides.
  std::vector<double> framesOverridden = {};       ///< Likewise.
  rig::HoldKind overriddenBy = rig::HoldKind::pin; ///< Hold that decides there.
};

/// Frames and half frames of the clip, at most some twenty thousand frames: where holds are looked at.
[[nodiscard]] std::vector<double> halfFramesOf(const rig::MotionState& motion);

/// One for each limb that a hold of the clip holds at any time, measured on the final frame wherever it holds
/// fully. `motion`: of the clip, with its holds.
[[nodiscard]] std::vector<HoldReport> holdReports(const Document& document, const rig::MotionState& motion);

/// One line for a hold that falls short: "the pin of left-arm falls short at frames 5 to 9 by up to 0.12".
/// Empty where it does not.
[[nodiscard]] std::string holdWarning(const HoldReport& report);

/// One line for a hold that another one overrides: "the pin of left-arm is left by up to 0.3 at frames 20 to
/// 40: the grip decides there". Empty where none does.
[[nodiscard]] std::string overrideWarning(const HoldReport& report);

/// "pin", "grip", "prop".
[[nodiscard]] const char* holdWord(rig::HoldKind kind);

} // namespace stretch::app

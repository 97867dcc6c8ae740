#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// A controller that does not come to where offsets, or what it follows, want it.
struct MissedPlace {
  std::string controller;
  std::vector<double> frames; ///< Frames at which it is farther off than a thousandth of the height, in
                              ///< order.
  double farthest = 0.0;      ///< World units.
  double worstFrame = 0.0;
};

/// One for each controller that misses its place at a frame, a half frame or a key of the clip, between its
/// keys too. `motion`: of the clip, with its adjustments; trails and holds are not looked at.
[[nodiscard]] std::vector<MissedPlace> missedPlaces(const Document& document, const rig::MotionState& motion);

/// One line with its frames and the worst of them.
[[nodiscard]] std::string missWarning(const MissedPlace& missed);

} // namespace stretch::app

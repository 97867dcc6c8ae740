#include "rig/motion/motion.h"

#include <algorithm>

namespace stretch::rig {

std::optional<std::size_t> placeOfTrail(const MotionState& motion, int trailId) {
  const auto found = std::ranges::find_if(
      motion.trails, [&](const SolvedTrail& solved) { return solved.trail.id == trailId; });
  return found == motion.trails.end() ? std::nullopt
                                      : std::optional<std::size_t>(found - motion.trails.begin());
}

} // namespace stretch::rig

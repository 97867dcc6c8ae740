#include "app/evaluate/stopped.h"

#include <algorithm>

#include "rig/motion/paths.h"

namespace stretch::app {

bool isStoppedAtTip(const Document& document, const rig::MotionState& motion,
                    const rig::SolvedTrail& solved) {
  if (!solved.settings.stopAt) {
    return false;
  }
  rig::MotionState unstopped = motion;
  const auto same = std::ranges::find_if(
      unstopped.trails, [&](const rig::SolvedTrail& trail) { return trail.trail.id == solved.trail.id; });
  if (same == unstopped.trails.end()) {
    return false;
  }
  same->settings.stopAt.reset();
  const auto tipIn =
      [&, trail = static_cast<std::size_t>(same - unstopped.trails.begin())](const rig::MotionState& with) {
        return rig::pathsAt(*document.scene, clipOf(document, motion.clip), with, trail,
                            {solved.tipSeconds * motion.framesPerSecond})
            .exaggerated;
      };
  return tipIn(motion) != tipIn(unstopped);
}

} // namespace stretch::app

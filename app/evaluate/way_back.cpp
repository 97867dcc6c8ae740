#include "app/evaluate/way_back.h"

#include <algorithm>

#include <fmt/core.h>

#include "rig/motion/seam.h"

namespace stretch::app {

namespace {

/// "at once", "in 1 frame", "in 2.5 frames".
std::string inFrames(double frames) {
  const std::string shown = fmt::format("{:.2g}", frames);
  return frames < 0.05 ? "at once" : "in " + shown + (shown == "1" ? " frame" : " frames");
}

} // namespace

bool endsMeet(const Document& document, int clip) {
  return rig::loopTravel(*document.scene, clipOf(document, clip), document.body.hips, document.body.height)
      .has_value();
}

std::optional<WayBackProblem> wayBackProblem(const Document& document, const rig::MotionState& motion,
                                             const rig::SolvedTrail& trail) {
  constexpr double hardly = 0.05; // frames
  const double used = trail.release.seconds() * motion.framesPerSecond;
  const double peaceful =
      std::min(trail.wantedReleaseSeconds, trail.calmReleaseSeconds) * motion.framesPerSecond;
  if (!trail.active || used > peaceful - hardly) {
    return std::nullopt;
  }
  const bool forwards = trail.settings.pivot == rig::Pivot::start;
  if (motion.loops) {
    return WayBackProblem{fmt::format("the limb {} {}, faster than the stroke, because its range begins "
                                      "again there; make the range shorter",
                                      forwards ? "snaps back" : "leaps out", inFrames(used)),
                          false};
  }
  if (endsMeet(document, motion.clip)) {
    return WayBackProblem{fmt::format("the clip's last pose is its first, and played as a loop the limb "
                                      "snaps back {} at the seam",
                                      inFrames(used)),
                          true};
  }
  if (used < hardly) {
    return std::nullopt; // The clip ends with the stretch: it is held.
  }
  return WayBackProblem{fmt::format("the limb {} {}, faster than the stroke, because the clip {} there; "
                                    "{} the range {}",
                                    forwards ? "snaps back" : "leaps out", inFrames(used),
                                    forwards ? "ends" : "begins", forwards ? "end" : "start",
                                    forwards ? "earlier" : "later"),
                        false};
}

} // namespace stretch::app

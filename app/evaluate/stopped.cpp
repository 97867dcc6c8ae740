#include "app/evaluate/stopped.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/hold_report.h"
#include "core/anim/frames.h"
#include "rig/motion/evaluate.h"
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
  // A stop that the tip but touches is met or not by rounding: neither a character's place nor its size
  // decides.
  constexpr double unseenStop = 1e-4; // of the limb
  return !std::ranges::equal(tipIn(motion), tipIn(unstopped), [&](const Vec3& a, const Vec3& b) {
    return glm::length(a - b) <= unseenStop * solved.limb.restLength;
  });
}

bool hasWantedLength(const Document& document, const rig::MotionState& motion,
                     const rig::SolvedTrail& solved) {
  constexpr double tolerance = 1e-4;
  const rig::LimbSample& tip =
      solved.settings.pivot == rig::Pivot::start ? solved.path.samples.back() : solved.path.samples.front();
  const double reference = solved.settings.reference == rig::Reference::pose ? glm::length(tip.end - tip.base)
                                                                             : solved.limb.restLength;
  const double wanted = solved.settings.scale * reference;
  const double after = rig::limbLength(solved.limb, evaluate(document, motion, solved.tipSeconds));
  return solved.tip.outcome != rig::TipOutcome::nothingToScale &&
         std::abs(after - wanted) <= tolerance * wanted;
}

std::string keptFromLength(const Document& document, const rig::MotionState& motion,
                           const rig::SolvedTrail& solved) {
  const bool isAsked = solved.active && solved.tip.outcome != rig::TipOutcome::nothingToScale &&
                       (solved.settings.scale != 1.0 || solved.settings.spheres.empty());
  if (!isAsked || hasWantedLength(document, motion, solved)) {
    return {};
  }
  FrameState frame =
      rig::adjustedFrame(*document.scene, clipOf(document, motion.clip), motion, solved.tipSeconds);
  for (const rig::HeldGoal& goal : rig::applyTrailsAndHolds(*document.scene, motion, frame)) {
    if (!goal.overriddenBy && motion.holds.limbs[goal.limb].limb.id == solved.limb.id) {
      return std::string("held by a ") + holdWord(goal.kind);
    }
  }
  if (isStoppedAtTip(document, motion, solved)) {
    return stoppedOnTheWay;
  }
  rig::MotionState alone = motion;
  for (rig::SolvedTrail& other : alone.trails) {
    other.active = other.active && (other.limb.id != solved.limb.id || other.trail.id == solved.trail.id);
  }
  return hasWantedLength(document, alone, solved) ? "shared with another trail of the limb" : "";
}

std::string keptBySettings(const rig::SolvedTrail& solved) {
  constexpr double exaggerated = 2.0; // of the blend
  const rig::TrailSettings& settings = solved.settings;
  if (settings.blend < exaggerated) {
    return "by its blend";
  }
  if (settings.stretchSwitch < 1.0) {
    return "by its stretch switch";
  }
  const double tipFrame = settings.pivot == rig::Pivot::start ? settings.endFrame : settings.startFrame;
  const bool isPulled = std::ranges::any_of(settings.spheres, [&](const rig::SphereOffset& sphere) {
    return sameFrame(sphere.frame, tipFrame) && sphere.offset != Vec3(0.0);
  });
  return isPulled ? "by the sphere at its tip" : "";
}

} // namespace stretch::app

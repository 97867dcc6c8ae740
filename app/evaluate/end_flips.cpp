#include "app/evaluate/end_flips.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/core.h>
#include <glm/gtc/quaternion.hpp>

#include "app/evaluate/hold_report.h"
#include "core/math/rotation.h"
#include "core/math/types.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

// How the end of a limb is turned at one time, and all that explains it.
struct EndTurns {
  Quat end;
  std::vector<Quat> causes; // without holds, and of a grip its leader
};

// By the place of the limb in SolvedHolds::limbs; those alone that a hold has a part of.
std::map<std::size_t, EndTurns> partsHeld(const rig::MotionState& motion,
                                          const std::vector<rig::HeldGoal>& goals, const FrameState& state,
                                          const FrameState& unheld) {
  std::map<std::size_t, EndTurns> turns;
  for (const rig::HeldGoal& goal : goals) {
    if (goal.overriddenBy || goal.strength >= 1.0) {
      continue;
    }
    const rig::Limb& limb = motion.holds.limbs[goal.limb].limb;
    EndTurns& own = turns[goal.limb];
    own = {rig::endPlace(limb, state).orientation, {rig::endPlace(limb, unheld).orientation}};
    if (goal.kind == rig::HoldKind::grip) {
      own.causes.push_back(rig::endPlace(motion.holds.grips[goal.index]->leader, state).orientation);
    }
  }
  return turns;
}

// How far the end turns, in degrees, where nothing explains it; 0 where something does.
double endFlipBetween(const EndTurns& before, const EndTurns& after) {
  constexpr double timesCauses = 3.0;
  constexpr double least = 45.0 / 180.0 * pi;
  double causes = 0.0;
  for (std::size_t i = 0; i < std::min(before.causes.size(), after.causes.size()); ++i) {
    causes = std::max(causes, angleBetween(before.causes[i], after.causes[i]));
  }
  const double turned = angleBetween(before.end, after.end);
  return turned > least + timesCauses * causes ? turned * 180.0 / pi : 0.0;
}

void keepWorst(const EndFlip& flip, std::vector<EndFlip>& flips) {
  const auto known = std::ranges::find(flips, flip.limb, &EndFlip::limb);
  if (known == flips.end()) {
    flips.push_back(flip);
  } else if (flip.degrees > known->degrees) {
    *known = flip;
  }
}

} // namespace

std::vector<EndFlip> endFlips(const Document& document, const rig::MotionState& motion) {
  std::vector<EndFlip> flips;
  const Clip& clip = clipOf(document, motion.clip);
  rig::MotionState free = motion;
  free.holds = {};
  std::map<std::size_t, EndTurns> last;
  for (const double frame : motion.holds.empty() ? std::vector<double>{} : halfFramesOf(motion)) {
    const double seconds = frame / clip.framesPerSecond;
    FrameState state = rig::adjustedFrame(*document.scene, clip, motion, seconds);
    std::vector<rig::HeldGoal> goals = rig::applyTrailsAndHolds(*document.scene, motion, state);
    rig::applyAfterHolds(*document.scene, motion, goals, state);
    if (std::ranges::none_of(goals, [](const rig::HeldGoal& goal) { return goal.strength < 1.0; })) {
      last.clear();
      continue;
    }
    const FrameState unheld = rig::evaluateMotion(*document.scene, clip, free, seconds);
    std::map<std::size_t, EndTurns> turns = partsHeld(motion, goals, state, unheld);
    for (const rig::HeldGoal& goal : goals) {
      const auto before = last.find(goal.limb);
      const auto after = turns.find(goal.limb);
      const bool isLooked = !goal.overriddenBy && before != last.end() && after != turns.end();
      if (const double degrees = isLooked ? endFlipBetween(before->second, after->second) : 0.0;
          degrees > 0.0) {
        keepWorst({goal.kind, motion.holds.limbs[goal.limb].limb.id, frame, degrees}, flips);
      }
    }
    last = std::move(turns);
  }
  return flips;
}

std::string endFlipWarning(const EndFlip& flip) {
  return fmt::format(
      "the end of {} turns over by {:.0f} degrees at frame {:g}, as its {} comes or goes: it is "
      "turned by half a turn there against how that has it; let the blend be shorter, or the "
      "hold leave its turn free",
      flip.limb, flip.degrees, flip.frame, holdWord(flip.kind));
}

} // namespace stretch::app

#include "app/evaluate/prop_flips.h"

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

// How something is turned at one time, and what explains it: of a prop its hands where nothing holds them.
struct Turns {
  Quat turned;
  std::vector<Quat> causes;
};

Turns turnsAt(const rig::SolvedHolds& holds, const rig::SolvedProp& prop, const FrameState& state,
              const FrameState& unheld) {
  Turns turns{rotationOf(state.worlds[at(prop.node)]), {}};
  for (const rig::SolvedPropHand& hand : prop.hands) {
    turns.causes.push_back(rig::endPlace(holds.limbs[hand.limb].limb, unheld).orientation);
  }
  return turns;
}

// Turns of the ends that a hold has a part of, by the place of the limb in SolvedHolds::limbs; of a grip its
// leader explains it, too.
std::map<std::size_t, Turns> partsHeld(const rig::MotionState& motion,
                                       const std::vector<rig::HeldGoal>& goals, const FrameState& state,
                                       const FrameState& unheld) {
  std::map<std::size_t, Turns> turns;
  for (const rig::HeldGoal& goal : goals) {
    if (goal.overriddenBy || goal.strength >= 1.0) {
      continue;
    }
    const rig::Limb& limb = motion.holds.limbs[goal.limb].limb;
    Turns& own = turns[goal.limb];
    own = {rig::endPlace(limb, state).orientation, {rig::endPlace(limb, unheld).orientation}};
    if (goal.kind == rig::HoldKind::grip) {
      own.causes.push_back(rig::endPlace(motion.holds.grips[goal.index]->leader, state).orientation);
    }
  }
  return turns;
}

// How far something turns, in degrees, where its causes do not explain it; 0 where they do.
double flipBetween(const Turns& before, const Turns& after) {
  constexpr double timesCauses = 3.0;
  constexpr double least = 45.0 / 180.0 * pi;
  double causes = 0.0;
  for (std::size_t i = 0; i < std::min(before.causes.size(), after.causes.size()); ++i) {
    causes = std::max(causes, angleBetween(before.causes[i], after.causes[i]));
  }
  const double turned = angleBetween(before.turned, after.turned);
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

std::vector<PropFlip> propFlips(const Document& document, const rig::MotionState& motion) {
  const std::vector<std::optional<rig::SolvedProp>>& props = motion.holds.props;
  std::vector<std::optional<Turns>> last(props.size());
  std::vector<PropFlip> flips(props.size());
  const bool anyInTwo =
      std::ranges::any_of(props, [](const auto& prop) { return prop && prop->hands.size() > 1; });
  const Clip& clip = clipOf(document, motion.clip);
  rig::MotionState free = motion;
  free.holds = {};
  for (const double frame : anyInTwo ? halfFramesOf(motion) : std::vector<double>{}) {
    const double seconds = frame / clip.framesPerSecond;
    const FrameState unheld = rig::evaluateMotion(*document.scene, clip, free, seconds);
    const FrameState state = rig::evaluateMotion(*document.scene, clip, motion, seconds);
    for (std::size_t i = 0; i < props.size(); ++i) {
      if (!props[i] || props[i]->hands.size() < 2) {
        continue;
      }
      Turns turns = turnsAt(motion.holds, *props[i], state, unheld);
      const double degrees = last[i] ? flipBetween(*last[i], turns) : 0.0;
      if (degrees > flips[i].degrees) {
        const std::string& name = document.scene->nodes[at(props[i]->node)].name;
        flips[i] = {name.empty() ? fmt::format("#{}", props[i]->node.value) : name, frame, degrees};
      }
      last[i] = std::move(turns);
    }
  }
  std::erase_if(flips, [](const PropFlip& flip) { return flip.degrees <= 0.0; });
  return flips;
}

std::string flipWarning(const PropFlip& flip) {
  return fmt::format("the prop \"{}\" turns over by {:.0f} degrees at frame {:g}: its hands are turned "
                     "against each other there by half a "
                     "turn; let one hand hold it more firmly from a frame before",
                     flip.prop, flip.degrees, flip.frame);
}

std::vector<EndFlip> endFlips(const Document& document, const rig::MotionState& motion) {
  std::vector<EndFlip> flips;
  const Clip& clip = clipOf(document, motion.clip);
  rig::MotionState free = motion;
  free.holds = {};
  std::map<std::size_t, Turns> last;
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
    std::map<std::size_t, Turns> turns = partsHeld(motion, goals, state, unheld);
    for (const rig::HeldGoal& goal : goals) {
      const auto before = last.find(goal.limb);
      const auto after = turns.find(goal.limb);
      const bool isLooked = !goal.overriddenBy && before != last.end() && after != turns.end();
      if (const double degrees = isLooked ? flipBetween(before->second, after->second) : 0.0; degrees > 0.0) {
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

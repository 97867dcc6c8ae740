#include "app/evaluate/prop_flips.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>
#include <glm/gtc/quaternion.hpp>

#include "app/evaluate/hold_report.h"
#include "core/math/rotation.h"
#include "core/math/types.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

// How a prop is turned at one time, and its hands where nothing holds them.
struct Turns {
  Quat prop;
  std::vector<Quat> hands;
};

Turns turnsAt(const rig::SolvedHolds& holds, const rig::SolvedProp& prop, const FrameState& state,
              const FrameState& unheld) {
  Turns turns{rotationOf(state.worlds[at(prop.node)]), {}};
  for (const rig::SolvedPropHand& hand : prop.hands) {
    turns.hands.push_back(rig::endPlace(holds.limbs[hand.limb].limb, unheld).orientation);
  }
  return turns;
}

// How far the prop turns, in degrees, where its hands do not explain it; 0 where they do.
double flipBetween(const Turns& before, const Turns& after) {
  constexpr double timesHands = 3.0;
  constexpr double least = 45.0 / 180.0 * pi;
  double hands = 0.0;
  for (std::size_t i = 0; i < before.hands.size(); ++i) {
    hands = std::max(hands, angleBetween(before.hands[i], after.hands[i]));
  }
  const double turned = angleBetween(before.prop, after.prop);
  return turned > least + timesHands * hands ? turned * 180.0 / pi : 0.0;
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

} // namespace stretch::app

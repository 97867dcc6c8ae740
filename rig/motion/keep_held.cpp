#include "rig/motion/keep_held.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/reach/limb_deform.h"
#include "rig/reach/limb_weight.h"

namespace stretch::rig {

namespace {

constexpr double unmoved = 1e-10; // of the limb

// What an end is held by, as the holds left it and as it is now; nothing holds by the world.
struct Anchor {
  HeldPlace before;
  HeldPlace now;

  [[nodiscard]] HeldPlace carried(const HeldPlace& place) const {
    return placedOn(now, seenFrom(before, place));
  }
};

class Keeper {
public:
  Keeper(const Scene& scene, const MotionState& motion, const FrameState& before, FrameState& frame)
      : scene_(scene), holds_(motion.holds), before_(before), frame_(frame) {}

  void run(std::vector<HeldGoal>& goals) {
    for (std::size_t i = 0; i < goals.size();) {
      std::size_t end = i + 1;
      while (end < goals.size() && goals[end].kind == goals[i].kind && goals[end].index == goals[i].index) {
        ++end;
      }
      const Anchor anchor = anchorOf(goals, i, end);
      for (; i < end; ++i) {
        bringBack(anchor, goals[i]);
      }
    }
  }

private:
  // Of the goals of one hold, from `first` to before `end`; a prop is brought along.
  Anchor anchorOf(const std::vector<HeldGoal>& goals, std::size_t first, std::size_t end) {
    if (goals[first].kind == HoldKind::grip) {
      const Limb& leader = holds_.grips[goals[first].index]->leader;
      return {endPlace(leader, before_), endPlace(leader, frame_)};
    }
    return goals[first].kind == HoldKind::prop ? propAnchor(goals, first, end) : Anchor{};
  }

  Anchor propAnchor(const std::vector<HeldGoal>& goals, std::size_t first, std::size_t end) {
    const SolvedProp& prop = *holds_.props[goals[first].index];
    const HeldPlace propBefore = propPlace(prop, before_);
    HeldPlace held;
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) {
      const Limb& hand = holds_.limbs[goals[i].limb].limb;
      const HeldPlace own = Anchor{endPlace(hand, before_), endPlace(hand, frame_)}.carried(propBefore);
      sum += goals[i].strength;
      held = i == first ? own : between(held, own, goals[i].strength / sum);
    }
    const double share = std::min(prop.span.strengthAt(frame_.timeSeconds), sum);
    const HeldPlace now = propPlace(prop, frame_);
    const HeldPlace goal = between(now, held, share);
    const Quat turn = goal.orientation * glm::inverse(now.orientation);
    const double moved = glm::length(goal.position - now.position);
    if (moved > unmoved * holds_.limbs[goals[first].limb].limb.restLength || isTurn(turn)) {
      placeNode(scene_, prop.node, turn, goal.position, frame_);
    }
    return {propBefore, held};
  }

  [[nodiscard]] static HeldPlace propPlace(const SolvedProp& prop, const FrameState& frame) {
    const Mat4& world = frame.worlds[at(prop.node)];
    return {positionOf(world), rotationOf(world)};
  }

  // Weight leaves the end's orientation alone.
  void bringBack(const Anchor& anchor, HeldGoal& goal) {
    const ReachingLimb& held = holds_.limbs[goal.limb];
    const Vec3 wanted = anchor.carried(endPlace(held.limb, before_)).position;
    goal.wanted = anchor.carried({goal.wanted, {}}).position;
    const Vec3 now = endPosition(held.limb, frame_);
    const Vec3 target = now + goal.strength * (wanted - now);
    if (glm::length(target - now) > unmoved * held.limb.restLength) {
      bendBack(scene_, held.limb, held.topology, target, frame_);
    }
  }

  const Scene& scene_;
  const SolvedHolds& holds_;
  const FrameState& before_;
  FrameState& frame_;
};

} // namespace

void keepHeld(const Scene& scene, const MotionState& motion, const FrameState& before,
              std::vector<HeldGoal>& goals, FrameState& frame) {
  Keeper(scene, motion, before, frame).run(goals);
}

} // namespace stretch::rig

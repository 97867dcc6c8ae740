#include "rig/motion/solve_holds.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <glm/geometric.hpp>

#include "core/anim/key_time.h"
#include "core/math/rotation.h"
#include "rig/adjust/adjusted_sampler.h"
#include "rig/ik/spline_spine.h"
#include "rig/motion/solve_steps.h"
#include "rig/trail/limb_path.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

// A turn of a loop on which the hips come back to where they began; 0 where what is held at one place is left
// behind, or nothing loops.
double turnOf(const MotionInput& input) {
  if (!input.loops || !input.hips.exists()) {
    return 0.0;
  }
  constexpr double negligible = 0.02; // of the longest limb
  double longest = 0.0;
  for (const Limb& limb : input.limbs) {
    longest = std::max(longest, limb.restLength);
  }
  const NodeSampler sampler(*input.scene, *input.clip, {input.hips});
  FrameState first;
  FrameState last;
  sampler.sample(input.clip->startSeconds, first);
  sampler.sample(input.clip->endSeconds, last);
  const double travel =
      glm::length(positionOf(last.worlds[at(input.hips)]) - positionOf(first.worlds[at(input.hips)]));
  return travel <= negligible * longest ? input.clip->endSeconds - input.clip->startSeconds : 0.0;
}

HoldSpan spanOf(const HoldTime& time, double framesPerSecond, double turnSeconds) {
  return {time.rangeFrames.x / framesPerSecond, time.rangeFrames.y / framesPerSecond,
          time.blendFrames.x / framesPerSecond, time.blendFrames.y / framesPerSecond, turnSeconds};
}

// With a key where each fade begins.
std::vector<OffsetKey> withFades(const std::vector<OffsetKey>& keys) {
  std::vector<OffsetKey> faded;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    faded.push_back(keys[i]);
    const bool holds = i + 1 < keys.size() && keys[i].interpolation == KeyInterpolation::automatic &&
                       keys[i + 1].frame - keys[i].frame > firmnessFadeFrames;
    if (holds) {
      faded.push_back(keys[i]);
      faded.back().frame = keys[i + 1].frame - firmnessFadeFrames;
    }
  }
  return faded;
}

// What is solved on the way.
class HoldSolver {
public:
  HoldSolver(const MotionInput& input, const MotionState& motion)
      : input_(input), adjustments_(motion.adjustments), places_(bindPlaces(*input.scene)),
        turnSeconds_(turnOf(input)) {}

  SolvedHolds run() {
    for (const Pin& pin : input_.holds.pins) {
      solved_.pins.push_back(solve(pin));
    }
    for (const Grip& grip : input_.holds.grips) {
      solved_.grips.push_back(solve(grip));
    }
    for (const Prop& prop : input_.holds.props) {
      solved_.props.push_back(solve(prop));
    }
    std::ranges::sort(solved_.nodes);
    solved_.nodes.erase(std::unique(solved_.nodes.begin(), solved_.nodes.end()), solved_.nodes.end());
    return std::move(solved_);
  }

private:
  [[nodiscard]] double framesPerSecond() const { return input_.clip->framesPerSecond; }

  void addNodes(const Limb& limb) {
    const std::vector<NodeIndex> own = jointsAndEnd(limb);
    solved_.nodes.insert(solved_.nodes.end(), own.begin(), own.end());
  }

  // Place in SolvedHolds::limbs.
  std::size_t held(const Limb& limb) {
    const auto known = std::ranges::find_if(
        solved_.limbs, [&](const ReachingLimb& reaching) { return reaching.limb.id == limb.id; });
    if (known != solved_.limbs.end()) {
      return static_cast<std::size_t>(known - solved_.limbs.begin());
    }
    solved_.limbs.push_back(reachingLimb({*input_.scene, *input_.clip, input_.limbs, places_}, limb));
    const std::vector<NodeIndex> touched = touchedNodes(limb, solved_.limbs.back().topology);
    solved_.nodes.insert(solved_.nodes.end(), touched.begin(), touched.end());
    addNodes(limb);
    return solved_.limbs.size() - 1;
  }

  [[nodiscard]] FrameState adjustedAt(double frame, std::vector<NodeIndex> nodes) const {
    const double seconds = std::min(frame / framesPerSecond(), input_.clip->endSeconds);
    FrameState state;
    AdjustedSampler(*input_.scene, *input_.clip, adjustments_, std::move(nodes)).sample(seconds, state);
    return state;
  }

  std::optional<SolvedPin> solve(const Pin& pin) {
    const Limb* const limb = limbOf(input_, pin.limb);
    if (limb == nullptr) {
      return std::nullopt;
    }
    const HeldPlace place =
        pin.place ? *pin.place : endPlace(*limb, adjustedAt(pin.atFrame, jointsAndEnd(*limb)));
    return SolvedPin{held(*limb), spanOf(pin.time, framesPerSecond(), turnSeconds_), place, pin.turns,
                     pin.stretch};
  }

  std::optional<SolvedGrip> solve(const Grip& grip) {
    const Limb* const follower = limbOf(input_, grip.follower);
    const Limb* const leader = limbOf(input_, grip.leader);
    if (follower == nullptr || leader == nullptr || follower == leader) {
      return std::nullopt;
    }
    SolvedGrip solved{
        held(*follower), *leader, spanOf(grip.time, framesPerSecond(), turnSeconds_), {}, grip.stretch};
    addNodes(*leader);
    if (grip.relationFrame) {
      std::vector<NodeIndex> nodes = jointsAndEnd(*leader);
      const std::vector<NodeIndex> more = jointsAndEnd(*follower);
      nodes.insert(nodes.end(), more.begin(), more.end());
      const FrameState state = adjustedAt(*grip.relationFrame, nodes);
      solved.relation = seenFrom(endPlace(*leader, state), endPlace(*follower, state));
    }
    return solved;
  }

  std::optional<SolvedProp> solve(const Prop& prop) {
    SolvedProp solved;
    solved.node = propNode(*input_.scene, prop.node);
    if (!solved.node.exists()) {
      return std::nullopt;
    }
    solved.span = prop.time ? spanOf(*prop.time, framesPerSecond(), turnSeconds_) : HoldSpan{};
    solved.stretch = prop.stretch;
    solved.move = prop.move;
    solved.turn = rotationOfVector(prop.turn);
    std::vector<NodeIndex> nodes{solved.node};
    for (const PropHand& hand : prop.hands) {
      if (const Limb* const limb = limbOf(input_, hand.limb)) {
        const std::vector<NodeIndex> more = jointsAndEnd(*limb);
        nodes.insert(nodes.end(), more.begin(), more.end());
      }
    }
    const std::optional<FrameState> bound =
        prop.boundFrame ? std::optional(adjustedAt(*prop.boundFrame, nodes)) : std::nullopt;
    for (const PropHand& hand : prop.hands) {
      const Limb* const limb = limbOf(input_, hand.limb);
      if (limb != nullptr && !isAncestorOrSelf(*input_.scene, solved.node, jointsAndEnd(*limb).back())) {
        Adjustment firmness;
        firmness.keys = withFades(hand.keys);
        solved.hands.push_back({held(*limb), OffsetCurve(firmness, 0.0, framesPerSecond()), {}});
        if (bound) {
          solved.hands.back().relation = seenFrom(endPlace(*limb, *bound), boundPlace(solved, *bound));
        }
      }
    }
    solved_.nodes.push_back(solved.node);
    return solved.hands.empty() ? std::nullopt : std::optional(std::move(solved));
  }

  const MotionInput& input_;
  const SolvedAdjustments& adjustments_;
  BindPlaces places_;
  double turnSeconds_ = 0.0;
  SolvedHolds solved_;
};

} // namespace

bool HoldSpan::actsInTurn(int turn) const {
  // What comes or goes without a blend jumps at the seam, as the clip does.
  return turn == 0 || (turnSeconds > 0.0 && (turn > 0 ? blendInSeconds : blendOutSeconds) > 0.0);
}

double HoldSpan::strengthAt(double timeSeconds) const {
  const double rounding = keyTimeRounding(timeSeconds);
  const auto beside = [&](double outside, double blend) {
    return outside <= rounding ? 1.0 : (blend > 0.0 ? 1.0 - smoothstep(outside / blend) : 0.0);
  };
  double strength = 0.0;
  for (int turn = -1; turn <= 1; ++turn) {
    if (!actsInTurn(turn)) {
      continue;
    }
    const double shift = turn * turnSeconds;
    const double before = startSeconds + shift - timeSeconds;
    const double after = timeSeconds - endSeconds - shift;
    strength = std::max(strength, std::min(beside(before, blendInSeconds), beside(after, blendOutSeconds)));
  }
  return strength;
}

HeldPlace endPlace(const Limb& limb, const FrameState& frame) {
  const NodeIndex turned = limb.endNode.exists() ? limb.endNode : limb.joints.back();
  return {endPosition(limb, frame), rotationOf(frame.worlds[at(turned)])};
}

bool isFullyHeld(const SolvedHolds& holds, const Limb& limb, double timeSeconds) {
  const auto isOf = [&](std::size_t place) { return holds.limbs[place].limb.id == limb.id; };
  const auto isFull = [&](const auto& hold) {
    return hold && isOf(hold->limb) && hold->span.strengthAt(timeSeconds) >= 1.0;
  };
  const auto isFirm = [&](const SolvedPropHand& hand) {
    return isOf(hand.limb) && hand.firmness.at(timeSeconds).value >= 1.0;
  };
  return std::ranges::any_of(holds.pins, isFull) || std::ranges::any_of(holds.grips, isFull) ||
         std::ranges::any_of(holds.props, [&](const std::optional<SolvedProp>& prop) {
           return prop && prop->span.strengthAt(timeSeconds) >= 1.0 &&
                  std::ranges::any_of(prop->hands, isFirm);
         });
}

HeldPlace seenFrom(const HeldPlace& from, const HeldPlace& place) {
  const Quat back = glm::inverse(from.orientation);
  return {back * (place.position - from.position), back * place.orientation};
}

HeldPlace placedOn(const HeldPlace& from, const HeldPlace& seen) {
  return {from.position + from.orientation * seen.position,
          glm::normalize(from.orientation * seen.orientation)};
}

HeldPlace between(const HeldPlace& a, const HeldPlace& b, double share) {
  if (share <= 0.0 || share >= 1.0) {
    return share <= 0.0 ? a : b;
  }
  return {a.position + share * (b.position - a.position), glm::slerp(a.orientation, b.orientation, share)};
}

HeldPlace boundPlace(const SolvedProp& prop, const FrameState& frame) {
  const Mat4& world = frame.worlds[at(prop.node)];
  return {positionOf(world) + prop.move, prop.turn * rotationOf(world)};
}

NodeIndex propNode(const Scene& scene, const std::string& name) {
  if (name.starts_with('#')) {
    int index = -1;
    const char* const end = name.data() + name.size();
    const bool isNumber = std::from_chars(name.data() + 1, end, index).ptr == end;
    return isNumber && index >= 0 && at(index) < scene.nodes.size() ? NodeIndex(index) : NodeIndex::none;
  }
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  return found == scene.nodes.end() || name.empty()
             ? NodeIndex::none
             : NodeIndex(at(static_cast<int>(found - scene.nodes.begin())));
}

void setHolds(const MotionInput& input, MotionState& motion) {
  motion.holds = input.holds.empty() ? SolvedHolds{} : HoldSolver(input, motion).run();
}

} // namespace stretch::rig

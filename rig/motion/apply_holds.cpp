#include "rig/motion/apply_holds.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/polyline.h"
#include "core/math/rotation.h"
#include "rig/reach/limb_deform.h"

namespace stretch::rig {

namespace {

double stretchedVolume(const FrameState& frame, NodeIndex joint) {
  return frame.stretch.empty() ? 1.0 : glm::determinant(frame.stretch[at(joint)]);
}

// Volume preservation, 0..1, of what made the limb `growth` times as long as in the source: a bone that is s
// times as long and s^(-v/2) times as thick has s^(1-v) times the volume (docs/exaggeration.md). Read from
// the frame, since several trails may have a part in it at one time.
double keptVolume(const Limb& limb, double growth, const FrameState& source, const FrameState& frame) {
  double change = 0.0;
  for (const NodeIndex joint : limb.joints) {
    const double own = std::log(stretchedVolume(frame, joint) / stretchedVolume(source, joint));
    change = std::abs(own) > std::abs(change) ? own : change;
  }
  const double volume = 1.0 - change / std::log(growth);
  return std::isfinite(volume) ? std::clamp(volume, 0.0, 1.0) : 1.0;
}

class Holder {
public:
  Holder(const Scene& scene, const MotionState& motion, const FrameState& source, FrameState& frame)
      : scene_(scene), motion_(motion), holds_(motion.holds), source_(source), frame_(frame),
        gripsDone_(motion.holds.grips.size(), false) {}

  std::vector<HeldGoal> run() {
    for (std::size_t i = 0; i < holds_.pins.size(); ++i) {
      if (holds_.pins[i]) {
        const SolvedPin& pin = *holds_.pins[i];
        hold({HoldKind::pin, i, pin.limb, {}, strengthOf(pin.span)}, pin.place, pin.turns, pin.stretch);
      }
    }
    for (std::size_t i = 0; i < holds_.grips.size(); ++i) {
      grip(i);
    }
    for (std::size_t i = 0; i < holds_.props.size(); ++i) {
      if (holds_.props[i] && strengthOf(holds_.props[i]->span) > 0.0) {
        holdProp(i, *holds_.props[i]);
      }
    }
    return std::move(goals_);
  }

private:
  [[nodiscard]] double strengthOf(const HoldSpan& span) const { return span.strengthAt(frame_.timeSeconds); }
  // The limb's attribute, 0 to `largest`.
  [[nodiscard]] double attributeOf(const Limb& limb, const char* name, double standard,
                                   double largest) const {
    const Offset keyed = offsetAt(motion_.adjustments.curves, limb.id + name, frame_.timeSeconds, standard);
    return std::clamp(keyed.value, 0.0, largest);
  }

  // After the grip that moves its leader.
  void grip(std::size_t index) {
    if (gripsDone_[index]) {
      return;
    }
    gripsDone_[index] = true;
    if (!holds_.grips[index] || strengthOf(holds_.grips[index]->span) <= 0.0) {
      return;
    }
    const SolvedGrip& own = *holds_.grips[index];
    for (std::size_t i = 0; i < holds_.grips.size(); ++i) {
      if (holds_.grips[i] && holds_.limbs[holds_.grips[i]->limb].limb.id == own.leader.id) {
        grip(i);
      }
    }
    const Limb& follower = holds_.limbs[own.limb].limb;
    const HeldPlace relation =
        own.relation ? *own.relation : seenFrom(endPlace(own.leader, source_), endPlace(follower, source_));
    hold({HoldKind::grip, index, own.limb, {}, strengthOf(own.span)},
         placedOn(endPlace(own.leader, frame_), relation), true, own.stretch);
  }

  [[nodiscard]] double firmnessOf(const SolvedPropHand& hand) const {
    return std::clamp(hand.firmness.at(frame_.timeSeconds).value, 0.0, 1.0);
  }

  [[nodiscard]] HeldPlace relationOf(const SolvedProp& prop, const SolvedPropHand& hand) const {
    return hand.relation
               ? *hand.relation
               : seenFrom(endPlace(holds_.limbs[hand.limb].limb, source_), boundPlace(prop, source_));
  }

  // Where the hands, by their shares, have the prop.
  [[nodiscard]] HeldPlace heldBy(const SolvedProp& prop) const {
    HeldPlace mixed;
    double sum = 0.0;
    for (const SolvedPropHand& hand : prop.hands) {
      const double firmness = firmnessOf(hand);
      if (firmness > 0.0) {
        const HeldPlace own =
            placedOn(endPlace(holds_.limbs[hand.limb].limb, frame_), relationOf(prop, hand));
        sum += firmness;
        mixed = between(mixed, own, sum == firmness ? 1.0 : firmness / sum);
      }
    }
    return mixed;
  }

  void holdProp(std::size_t index, const SolvedProp& prop) {
    double firmness = 0.0;
    for (const SolvedPropHand& hand : prop.hands) {
      firmness += firmnessOf(hand);
    }
    if (firmness <= 0.0) {
      return;
    }
    const double strength = strengthOf(prop.span);
    const HeldPlace held = heldBy(prop);
    const Mat4& world = frame_.worlds[at(prop.node)];
    const HeldPlace goal =
        between({positionOf(world), rotationOf(world)}, held, strength * std::min(1.0, firmness));
    for (const SolvedPropHand& hand : prop.hands) {
      const HeldPlace onProp = placedOn(held, seenFrom(relationOf(prop, hand), {}));
      hold({HoldKind::prop, index, hand.limb, {}, strength * firmnessOf(hand)}, onProp, true, prop.stretch);
    }
    place(prop.node, goal);
  }

  void place(NodeIndex node, const HeldPlace& goal) {
    const Mat4& world = frame_.worlds[at(node)];
    const Quat turn = goal.orientation * glm::inverse(rotationOf(world));
    if (glm::length(goal.position - positionOf(world)) > 0.0 || isTurn(turn)) {
      placeNode(scene_, node, turn, goal.position, frame_);
    }
  }

  void hold(HeldGoal what, const HeldPlace& wanted, bool turns, double stretch) {
    if (what.strength <= 0.0) {
      return;
    }
    const ReachingLimb& reaching = holds_.limbs[what.limb];
    for (HeldGoal& earlier : goals_) {
      if (earlier.limb == what.limb) {
        earlier.overriddenBy = what.kind;
      }
    }
    what.wanted = wanted.position;
    goals_.push_back(what);
    const HeldPlace now = endPlace(reaching.limb, frame_);
    const HeldPlace goal = between(now, wanted, what.strength);
    ReachGoal reachGoal;
    reachGoal.place = goal.position;
    if (turns && reaching.limb.endNode.exists()) {
      reachGoal.endTurn = goal.orientation * glm::inverse(now.orientation);
    }
    constexpr double unseen = 1e-10; // of the limb
    const bool isThere = glm::length(goal.position - now.position) <= unseen * reaching.limb.restLength;
    if (isThere && !isTurn(reachGoal.endTurn)) {
      return;
    }
    reachGoal.stretchSwitch = stretch;
    reachGoal.volume = attributeOf(reaching.limb, ".volume", 1.0, 1.0);
    reachGoal.softness = attributeOf(reaching.limb, ".softness", 0.0, mostSoftness);
    takeStretchBack(reaching, what.strength, goal.position);
    reach(scene_, reaching, reachGoal, frame_);
  }

  // What a trail of its own made of the limb's length gives way to the hold: an arm three times as long would
  // have to fold up. The limb is turned towards its goal with it.
  void takeStretchBack(const ReachingLimb& reaching, double strength, const Vec3& goal) {
    constexpr double negligible = 1e-9;
    const std::vector<Vec3> points = limbPoints(reaching.limb, frame_);
    const double before = polylineLength(limbPoints(reaching.limb, source_));
    const double now = polylineLength(points);
    const Vec3 line = goal - points.front();
    const double span = glm::length(points.back() - points.front());
    if (!(before > 0.0) || !(now > 0.0) || std::abs(now / before - 1.0) < negligible ||
        !(glm::length(line) > 0.0)) {
      return;
    }
    ReachGoal back;
    back.place = points.front() + glm::normalize(line) * span * std::pow(before / now, strength);
    back.volume = keptVolume(reaching.limb, now / before, source_, frame_);
    reachAsOne(scene_, reaching, back, frame_);
  }

  const Scene& scene_;
  const MotionState& motion_;
  const SolvedHolds& holds_;
  const FrameState& source_;
  FrameState& frame_;
  std::vector<bool> gripsDone_;
  std::vector<HeldGoal> goals_;
};

} // namespace

std::vector<HeldGoal> applyHolds(const Scene& scene, const MotionState& motion, const FrameState& source,
                                 FrameState& frame) {
  if (motion.holds.empty()) {
    return {};
  }
  return Holder(scene, motion, source, frame).run();
}

} // namespace stretch::rig

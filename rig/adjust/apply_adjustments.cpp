#include "rig/adjust/apply_adjustments.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/ik/spline_spine.h"
#include "rig/reach/limb_deform.h"

namespace stretch::rig {

namespace {

const Quat noTurn(1.0, 0.0, 0.0, 0.0);

struct NamedOffset {
  std::string_view id; // of the controller or attribute
  Offset offset;
};

// Of all that is keyed at the time: asked once for each, not by its name at every turn.
std::vector<NamedOffset> offsetsAt(const OffsetCurves& curves, double timeSeconds) {
  std::vector<NamedOffset> offsets;
  for (const auto& [id, ofId] : curves) {
    if (std::ranges::any_of(ofId, [&](const OffsetCurve& curve) { return curve.covers(timeSeconds); })) {
      offsets.push_back({id, offsetAt(curves, id, timeSeconds)});
    }
  }
  return offsets;
}

bool movesAnything(const NamedOffset& named) {
  const bool drives = named.id.ends_with(".curl") || named.id.ends_with(".roll");
  const Offset& offset = named.offset;
  return offset.move != Vec3(0.0) || offset.turn != Vec3(0.0) || (drives && offset.value != 0.0);
}

// How a carrier took along what it carries, as one piece.
struct CarrierChange {
  Vec3 before{0.0};
  Vec3 now{0.0};
  Quat turn{1.0, 0.0, 0.0, 0.0};

  [[nodiscard]] Vec3 point(const Vec3& world) const { return now + turn * (world - before); }
};

// Where an end is wanted, and how it is turned from its source orientation.
struct EndGoal {
  Vec3 place{0.0};
  Quat turn{1.0, 0.0, 0.0, 0.0};
};

// How a node turned in the world from one matrix to another.
Quat turnBetween(const Mat4& before, const Mat4& now) {
  return Mat3(before) == Mat3(now) ? noTurn : rotationOf(now) * glm::inverse(rotationOf(before));
}

class Adjuster {
public:
  Adjuster(const Scene& scene, const SolvedAdjustments& adjustments, FrameState& frame)
      : scene_(scene), adjustments_(adjustments), body_(*adjustments.body), frame_(frame),
        offsets_(offsetsAt(adjustments.curves, frame.timeSeconds)), done_(adjustments.joints.size(), false) {}

  /// Whether anything is to be done at the frame's time.
  [[nodiscard]] bool acts() const { return std::ranges::any_of(offsets_, movesAnything); }

  /// `spaces`: where to note how offsets count; null: nowhere.
  /// `source`: what the frame is a copy of; null: not at hand.
  std::vector<AskedPlace> run(const FrameState* source, std::vector<ControllerSpace>* spaces = nullptr) {
    spaces_ = spaces;
    asked_.reserve(body_.limbs.size() + 5); // those of the trunk
    const bool isCarried = moveBody();
    if (source == nullptr || isCarried) {
      carried_.worlds = frame_.worlds;
      carried_.stretch = frame_.stretch;
    }
    source_ = source == nullptr || isCarried ? &carried_ : source;
    moveHips();
    if (body_.spine && concerns(*body_.spine)) {
      turnJointsAbove(body_.spine->limb);
      moveSpine(*body_.spine);
    }
    if (body_.neck && concerns(*body_.neck)) {
      turnJointsAbove(body_.neck->limb);
      moveNeck(*body_.neck);
    }
    for (const AdjustedLimb& limb : body_.limbs) {
      if (concerns(limb)) {
        turnJointsAbove(limb.limb);
        moveLimb(limb);
      }
    }
    turnJointsLeft();
    return std::move(asked_);
  }

private:
  // A limb that no key moves goes along with what carries it, and a note of it may still be asked for.
  [[nodiscard]] bool concerns(const AdjustedLimb& adjusted) const {
    return spaces_ != nullptr || adjustments_.moves(adjusted.limb);
  }
  [[nodiscard]] Offset offset(std::string_view id, double standard = 0.0) const {
    const auto found = std::ranges::find(offsets_, id, &NamedOffset::id);
    return found == offsets_.end() ? Offset{Vec3(0.0), Vec3(0.0), standard} : found->offset;
  }
  [[nodiscard]] double attribute(std::string_view id, double standard, double low, double high) const {
    return std::clamp(offset(id, standard).value, low, high);
  }
  [[nodiscard]] Quat rotation(NodeIndex node) const { return rotationOf(frame_.worlds[at(node)]); }
  [[nodiscard]] Vec3 place(NodeIndex node) const { return positionOf(frame_.worlds[at(node)]); }

  void ask(const std::string& id, const Vec3& place) { asked_.push_back({id, place}); }

  void note(const char* id, const Quat& axes, const std::optional<Vec3>& place = std::nullopt) {
    if (spaces_ != nullptr) {
      spaces_->push_back({id, axes, place});
    }
  }

  // The scene's axes as they are carried from the bind pose.
  [[nodiscard]] Quat carriedAxes(NodeIndex carrier, const Quat& bind) const {
    return carrier.exists() ? rotation(carrier) * glm::inverse(bind) : noTurn;
  }

  [[nodiscard]] CarrierChange changeOf(NodeIndex carrier) const {
    CarrierChange change;
    if (carrier.exists() && frame_.worlds[at(carrier)] != source_->worlds[at(carrier)]) {
      change.before = positionOf(source_->worlds[at(carrier)]);
      change.now = place(carrier);
      change.turn = turnBetween(source_->worlds[at(carrier)], frame_.worlds[at(carrier)]);
    }
    return change;
  }

  // Answers whether it did.
  bool moveBody() {
    const Offset body = offset("body");
    noteBody(body);
    if (body.move == Vec3(0.0) && body.turn == Vec3(0.0)) {
      return false;
    }
    const Vec3 hips = place(body_.hips);
    const CarrierChange change{
        {hips.x, 0.0, hips.z}, Vec3(hips.x, 0.0, hips.z) + body.move, rotationOfVector(body.turn)};
    bodyTurn_ = change.turn;
    for (const NodeIndex root : body_.roots) {
      placeNode(scene_, root, change.turn, change.point(place(root)), frame_);
    }
    ask("body", change.point(hips));
    return true;
  }

  void noteBody(const Offset& body) {
    if (spaces_ != nullptr && body_.hips.exists()) {
      const Vec3 hips = place(body_.hips);
      note("body", noTurn, Vec3(hips.x, 0.0, hips.z) + body.move);
    }
  }

  void moveHips() {
    const Offset hips = offset("hips");
    note("hips", bodyTurn_);
    if (hips.move == Vec3(0.0) && hips.turn == Vec3(0.0)) {
      return;
    }
    const Vec3 goal = place(body_.hips) + bodyTurn_ * hips.move;
    const CarrierChange change{place(body_.hips), goal, rotationOfVector(bodyTurn_ * hips.turn)};
    placeNode(scene_, body_.hips, change.turn, goal, frame_);
    for (const NodeIndex node : body_.besideHips) {
      placeNode(scene_, node, change.turn, change.point(place(node)), frame_);
    }
    ask("hips", goal);
  }

  void turnJoint(std::size_t index) {
    const AdjustedJoint& joint = adjustments_.joints[index];
    done_[index] = true;
    const Offset own = offset(joint.id);
    if (own.turn != Vec3(0.0)) {
      const Quat axes = carriedAxes(scene_.nodes[at(joint.node)].parent, joint.parentBind);
      placeNode(scene_, joint.node, rotationOfVector(axes * own.turn), place(joint.node), frame_);
    }
  }

  void turnJointsAbove(const Limb& limb) {
    for (std::size_t i = 0; i < done_.size(); ++i) {
      if (!done_[i] && isAncestorOrSelf(scene_, adjustments_.joints[i].node, limb.joints.front())) {
        turnJoint(i);
      }
    }
  }

  void turnJointsLeft() {
    for (std::size_t i = 0; i < done_.size(); ++i) {
      if (!done_[i]) {
        turnJoint(i);
      }
    }
  }

  // What belongs to a limb and hangs elsewhere goes along with its base.
  void carryDetached(const AdjustedLimb& adjusted) {
    if (adjusted.detached.empty()) {
      return;
    }
    const NodeIndex carrier = adjusted.carrier;
    if (frame_.worlds[at(carrier)] == source_->worlds[at(carrier)]) {
      return;
    }
    const CarrierChange change = changeOf(carrier);
    for (const NodeIndex node : adjusted.detached) {
      const Quat left = change.turn * glm::inverse(turnSoFar(node));
      placeNode(scene_, node, left, change.point(positionOf(source_->worlds[at(node)])), frame_);
    }
  }

  [[nodiscard]] Quat turnSoFar(NodeIndex node) const {
    return turnBetween(source_->worlds[at(node)], frame_.worlds[at(node)]);
  }

  void moveSpine(const AdjustedLimb& adjusted) {
    const Offset low = offset("spine-low");
    const Offset middle = offset("spine-mid");
    const Offset top = offset("spine-top");
    const Quat axes = carriedAxes(body_.hips, body_.hipsBind);
    for (const char* id : {"spine-low", "spine-mid", "spine-top"}) {
      note(id, axes);
    }
    carryDetached(adjusted);
    const Vec3 none(0.0);
    if (low.move == none && middle.move == none && top.move == none && top.turn == none) {
      return;
    }
    const Limb& limb = adjusted.limb;
    SplineSpineProblem problem;
    problem.points = limbPoints(limb, frame_);
    problem.along = adjusted.along;
    problem.low = axes * low.move;
    problem.middle = axes * middle.move;
    problem.top = axes * top.move;
    problem.turn = axes * top.turn;
    problem.stretchSwitch = attribute(adjusted.controls.stretch, 1.0, 0.0, 1.0);
    const SplineSpineShape shape = solveSplineSpine(problem);
    DeformOptions options{attribute(adjusted.controls.volume, 1.0, 0.0, 1.0), false, shape.topTurn};
    deformLimb(
        scene_, limb, adjusted.topology,
        {shape.turns, shape.stretches, shape.points.front() - problem.points.front(), shape.points.back()},
        options, frame_);
    ask("spine-low", shape.wanted.front());
    ask("spine-top", shape.wanted.back());
  }

  // docs/controllers.md, Space and following.
  [[nodiscard]] EndGoal goalOf(const AdjustedLimb& adjusted, NodeIndex carrier, const Quat& carrierBind,
                               double standardFollow) const {
    const Limb& limb = adjusted.limb;
    const double follow = attribute(adjusted.controls.follow, standardFollow, 0.0, 1.0);
    const CarrierChange change = changeOf(carrier);
    const Vec3 stays = endPosition(limb, *source_);
    EndGoal goal{stays + follow * (change.point(stays) - stays),
                 follow >= 1.0 ? change.turn : glm::slerp(noTurn, change.turn, follow)};
    const Offset own = offset(adjusted.controls.end);
    if (own.move != Vec3(0.0) || own.turn != Vec3(0.0)) {
      const Quat axes = carriedAxes(carrier, carrierBind);
      goal.place += axes * own.move;
      goal.turn = rotationOfVector(axes * own.turn) * goal.turn;
    }
    return goal;
  }

  // How the end has to turn from where the frame has it.
  [[nodiscard]] Quat endTurn(const Limb& limb, const EndGoal& goal) const {
    return limb.endNode.exists() ? goal.turn * glm::inverse(turnSoFar(limb.endNode)) : noTurn;
  }

  [[nodiscard]] bool isThere(const Limb& limb, const EndGoal& goal) const {
    constexpr double unseen = 1e-10; // of the limb
    return glm::length(goal.place - endPosition(limb, frame_)) <= unseen * limb.restLength &&
           !isTurn(endTurn(limb, goal));
  }

  void reachGoal(const AdjustedLimb& adjusted, const EndGoal& goal, const Vec3& pole) {
    const Limb& limb = adjusted.limb;
    reach(scene_, adjusted,
          {goal.place, endTurn(limb, goal), attribute(adjusted.controls.stretch, 1.0, 0.0, 1.0),
           attribute(adjusted.controls.volume, 1.0, 0.0, 1.0),
           attribute(adjusted.controls.softness, 0.0, 0.0, mostSoftness), pole},
          frame_);
  }

  void moveNeck(const AdjustedLimb& adjusted) {
    carryDetached(adjusted);
    note("head", carriedAxes(body_.chest, body_.chestBind));
    const EndGoal goal = goalOf(adjusted, body_.chest, body_.chestBind, 1.0);
    ask("head", goal.place);
    if (!isThere(adjusted.limb, goal)) {
      reachGoal(adjusted, goal, Vec3(0.0));
    }
  }

  void moveLimb(const AdjustedLimb& adjusted) {
    carryDetached(adjusted);
    const Limb& limb = adjusted.limb;
    const bool leg = isLeg(limb);
    const double follow = leg ? 0.0 : 1.0;
    EndGoal goal = adjusted.hangsOnHips ? goalOf(adjusted, body_.hips, body_.hipsBind, follow)
                                        : goalOf(adjusted, body_.chest, body_.chestBind, follow);
    const double roll = leg ? attribute(adjusted.controls.roll, 0.0, -1.0, 1.0) : 0.0;
    const Quat rolled = rollFoot(adjusted, roll, goal);
    ask(adjusted.controls.end, goal.place);
    const Vec3 pole = poleOffset(adjusted);
    noteLimb(adjusted, pole);
    if (pole != Vec3(0.0) || !isThere(limb, goal)) {
      reachGoal(adjusted, goal, pole);
    }
    if (roll > 0.0 && adjusted.roll.toes.exists()) {
      placeNode(scene_, adjusted.roll.toes, glm::inverse(rolled), place(adjusted.roll.toes), frame_);
    }
    if (!leg) {
      applyCurl(scene_, adjusted.fingers, attribute(adjusted.controls.curl, 0.0, -0.2, 1.0), frame_);
    }
  }

  void noteLimb(const AdjustedLimb& adjusted, const Vec3& pole) {
    if (spaces_ == nullptr) {
      return;
    }
    const Quat axes = adjusted.hangsOnHips ? carriedAxes(body_.hips, body_.hipsBind)
                                           : carriedAxes(body_.chest, body_.chestBind);
    note(adjusted.controls.end.c_str(), axes);
    if (adjusted.bendPoint > 0) {
      TwoBoneProblem problem = posedLimb(adjusted, frame_);
      problem.poleOffset = pole;
      note(adjusted.controls.pole.c_str(), carriedAxes(adjusted.limb.joints.front(), adjusted.baseBind),
           polePlace(problem));
    }
  }

  // Turns the goal about the ball or the heel; answers by how much.
  [[nodiscard]] Quat rollFoot(const AdjustedLimb& adjusted, double roll, EndGoal& goal) const {
    if (roll == 0.0 || adjusted.roll.axis == Vec3(0.0)) {
      return noTurn;
    }
    const Mat4& before = source_->worlds[at(adjusted.limb.endNode)];
    const Vec3 about = roll > 0.0 ? adjusted.roll.ball : adjusted.roll.heel;
    const Vec3 pivot = goal.place + goal.turn * transformVector(before, about);
    const Vec3 axis = goal.turn * (rotationOf(before) * adjusted.roll.axis);
    const Quat turn = axisAngle(axis, rollRadians(roll));
    goal.place = pivot + turn * (goal.place - pivot);
    goal.turn = turn * goal.turn;
    return turn;
  }

  [[nodiscard]] Vec3 poleOffset(const AdjustedLimb& adjusted) const {
    const Offset pole = offset(adjusted.controls.pole);
    return pole.move == Vec3(0.0) ? pole.move
                                  : carriedAxes(adjusted.limb.joints.front(), adjusted.baseBind) * pole.move;
  }

  const Scene& scene_;
  const SolvedAdjustments& adjustments_;
  const AdjustedBody& body_;
  FrameState& frame_;
  const FrameState* source_ = nullptr; // as the body's controller carries it; its pose does not count
  FrameState carried_;
  Quat bodyTurn_{1.0, 0.0, 0.0, 0.0};
  std::vector<NamedOffset> offsets_;
  std::vector<bool> done_; // of the joints
  std::vector<AskedPlace> asked_;
  std::vector<ControllerSpace>* spaces_ = nullptr;
};

std::vector<AskedPlace> adjusted(const Scene& scene, const SolvedAdjustments& adjustments,
                                 const FrameState* source, FrameState& frame) {
  if (adjustments.empty()) {
    return {};
  }
  Adjuster adjuster(scene, adjustments, frame);
  return adjuster.acts() ? adjuster.run(source) : std::vector<AskedPlace>{};
}

} // namespace

std::vector<AskedPlace> applyAdjustments(const Scene& scene, const SolvedAdjustments& adjustments,
                                         FrameState& frame) {
  return adjusted(scene, adjustments, nullptr, frame);
}

std::vector<AskedPlace> applyAdjustments(const Scene& scene, const SolvedAdjustments& adjustments,
                                         const FrameState& source, FrameState& frame) {
  return adjusted(scene, adjustments, &source, frame);
}

std::vector<ControllerSpace> controllerSpaces(const Scene& scene, const SolvedAdjustments& adjustments,
                                              FrameState& frame) {
  std::vector<ControllerSpace> spaces;
  static_cast<void>(Adjuster(scene, adjustments, frame).run(nullptr, &spaces));
  return spaces;
}

Vec3 posedPole(const AdjustedLimb& adjusted, const FrameState& frame) {
  return polePlace(posedLimb(adjusted, frame));
}

Vec3 controllerPlace(const SolvedAdjustments& adjustments, const std::string& controller,
                     const FrameState& frame) {
  const AdjustedBody& body = *adjustments.body;
  for (const std::optional<AdjustedLimb>* limb : {&body.spine, &body.neck}) {
    if (*limb && ((controller == "spine-top" && (*limb)->limb.kind == LimbKind::spine) ||
                  (controller == "head" && (*limb)->limb.kind == LimbKind::neck))) {
      return endPosition((*limb)->limb, frame);
    }
  }
  if (controller == "spine-low" && body.spine) {
    return positionOf(frame.worlds[at(body.spine->limb.joints.front())]);
  }
  for (const AdjustedLimb& limb : body.limbs) {
    if (controller == limb.controls.end) {
      return endPosition(limb.limb, frame);
    }
  }
  return positionOf(frame.worlds[at(body.hips)]);
}

} // namespace stretch::rig

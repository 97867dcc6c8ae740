#include "rig/motion/controller_places.h"

#include <algorithm>
#include <iterator>

#include <glm/gtc/quaternion.hpp>

#include "rig/adjust/apply_adjustments.h"
#include "rig/motion/evaluate.h"

namespace stretch::rig {

namespace {

const AdjustedLimb* limbWith(const AdjustedBody& body, const std::string& id) {
  for (const std::optional<AdjustedLimb>* limb : {&body.spine, &body.neck}) {
    if (*limb && (*limb)->limb.id == id) {
      return &**limb;
    }
  }
  const auto found =
      std::ranges::find_if(body.limbs, [&](const AdjustedLimb& limb) { return limb.limb.id == id; });
  return found == body.limbs.end() ? nullptr : &*found;
}

Quat turnFromBind(const AdjustedBody& body, const FrameState& frame, NodeIndex node) {
  return node.exists()
             ? rotationOf(frame.worlds[at(node)]) * glm::inverse(rotationOf(body.places.worlds[at(node)]))
             : Quat(1.0, 0.0, 0.0, 0.0);
}

// Half the way along the spine.
Vec3 middleOf(const AdjustedLimb& spine, const FrameState& frame) {
  const std::vector<Vec3> points = limbPoints(spine.limb, frame);
  const auto after = std::ranges::find_if(spine.along, [](double along) { return along >= 0.5; });
  const auto next = static_cast<std::size_t>(after - spine.along.begin());
  if (next == 0 || next >= points.size()) {
    return points.back();
  }
  const double length = spine.along[next] - spine.along[next - 1];
  const double share = length > 0.0 ? (0.5 - spine.along[next - 1]) / length : 0.0;
  return glm::mix(points[next - 1], points[next], share);
}

bool endHangsOnHips(const AdjustedBody& body, const std::string& endController) {
  return std::ranges::any_of(body.limbs, [&](const AdjustedLimb& limb) {
    return limb.hangsOnHips && limb.controls.end == endController;
  });
}

Carrier carrierOf(const AdjustedBody& body, const Controller& controller) {
  switch (controller.kind) {
  case ControllerKind::head:
    return Carrier::chest;
  case ControllerKind::spineLow:
  case ControllerKind::spineMiddle:
  case ControllerKind::spineTop:
    return Carrier::hips;
  case ControllerKind::hand:
  case ControllerKind::foot:
  case ControllerKind::tip:
    return endHangsOnHips(body, controller.id) ? Carrier::hips : Carrier::chest;
  case ControllerKind::body:
  case ControllerKind::hips:
  case ControllerKind::pole:
  case ControllerKind::joint:
    break;
  }
  return Carrier::scene;
}

// Trails may turn it after the adjustments; none: the scene.
NodeIndex carrierNode(const AdjustedBody& body, Carrier carrier) {
  return carrier == Carrier::hips ? body.hips : carrier == Carrier::chest ? body.chest : NodeIndex{};
}

Vec3 placeOnLimb(const AdjustedLimb& limb, ControllerKind kind, const FrameState& frame) {
  switch (kind) {
  case ControllerKind::spineLow:
    return positionOf(frame.worlds[at(limb.limb.joints.front())]);
  case ControllerKind::spineMiddle:
    return middleOf(limb, frame);
  case ControllerKind::pole:
    return posedPole(limb, frame);
  default:
    return endPosition(limb.limb, frame);
  }
}

class Placer {
public:
  explicit Placer(const PlacingInput& input)
      : input_(input), body_(*input.adjustments.body),
        adjusted_(sampledFrame(input.scene, input.clip, input.shown.timeSeconds)),
        spaces_(controllerSpaces(input.scene, input.adjustments, adjusted_)) {}

  [[nodiscard]] PlacedController place(const Controller& controller) const {
    PlacedController placed;
    placed.id = controller.id;
    placed.kind = controller.kind;
    placed.node = controller.node;
    placed.moves = controller.moves;
    placed.turns = controller.turns;
    placed.carrier = carrierOf(body_, controller);
    const AdjustedLimb* const limb = limbWith(body_, controller.limb);
    const NodeIndex node =
        !controller.node.exists() && limb != nullptr ? limb->limb.joints.back() : controller.node;
    placed.orientationWorld = turnFromBind(body_, input_.shown, node);
    placed.placeWorld = limb != nullptr ? placeOnLimb(*limb, controller.kind, input_.shown)
                        : node.exists() ? positionOf(input_.shown.worlds[at(node)])
                                        : Vec3(0.0);
    if (controller.kind == ControllerKind::joint) {
      const NodeIndex parent = input_.scene.nodes[at(controller.node)].parent;
      placed.carrierAxesWorld = glm::mat3_cast(turnFromBind(body_, input_.shown, parent));
    } else {
      setSpace(limb, placed);
    }
    return placed;
  }

private:
  void setSpace(const AdjustedLimb* limb, PlacedController& placed) const {
    const auto space = std::ranges::find(spaces_, placed.id, &ControllerSpace::controller);
    if (space == spaces_.end()) {
      return;
    }
    const NodeIndex carrier = carrierNode(body_, placed.carrier);
    const Quat since = carrier.exists() ? rotationOf(input_.shown.worlds[at(carrier)]) *
                                              glm::inverse(rotationOf(adjusted_.worlds[at(carrier)]))
                                        : Quat(1.0, 0.0, 0.0, 0.0);
    placed.carrierAxesWorld = glm::mat3_cast(since * space->axes);
    if (placed.kind == ControllerKind::body) {
      placed.placeWorld = *space->place;
      placed.orientationWorld = bodyTurn();
    }
    if (placed.kind == ControllerKind::pole && limb != nullptr) {
      placed.jointWorld = limbPoints(limb->limb, input_.shown)[limb->bendPoint];
      placed.slack = glm::inverse(space->axes) * (posedPole(*limb, adjusted_) - *space->place);
    }
  }

  [[nodiscard]] Quat bodyTurn() const {
    const auto hips = std::ranges::find(spaces_, "hips", &ControllerSpace::controller);
    return hips == spaces_.end() ? Quat(1.0, 0.0, 0.0, 0.0) : hips->axes;
  }

  const PlacingInput& input_;
  const AdjustedBody& body_;
  FrameState adjusted_;
  std::vector<ControllerSpace> spaces_;
};

} // namespace

std::vector<PlacedController> placeControllers(const PlacingInput& input) {
  const AdjustedBody& body = *input.adjustments.body;
  const Placer placer(input);
  std::vector<PlacedController> placed;
  for (const std::vector<Controller>* list : {&body.list.controllers, &body.jointControllers}) {
    std::ranges::transform(*list, std::back_inserter(placed),
                           [&](const Controller& controller) { return placer.place(controller); });
  }
  return placed;
}

} // namespace stretch::rig

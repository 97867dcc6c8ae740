#include "app/edits/pose/seen_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/edits/pose/pose_edits.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/named.h"
#include "app/standing_floor.h"
#include "core/math/rotation.h"
#include "rig/reach/bind_places.h"

namespace stretch::app {

namespace {

bool hangsOnItsLimb(rig::ControllerKind kind) {
  using rig::ControllerKind;
  return kind == ControllerKind::hand || kind == ControllerKind::head || kind == ControllerKind::tip ||
         kind == ControllerKind::pole;
}

/// The base of the controller's limb, where it is placed from there.
std::optional<Vec3> baseOf(const SeenMoment& moment, const rig::Controller* controller) {
  if (controller == nullptr || !hangsOnItsLimb(controller->kind)) {
    return std::nullopt;
  }
  const std::vector<rig::Limb>& limbs = moment.document.body.limbs;
  const auto limb = std::ranges::find(limbs, controller->limb, &rig::Limb::id);
  return limb == limbs.end() ? std::nullopt
                             : std::optional(positionOf(moment.shown.worlds[at(limb->joints.front())]));
}

/// A turn from a bind pose that is symmetric by one plane, seen in a mirror that stands on another one.
Quat reflectedTurn(const Quat& turn, const Vec3& bindNormal, const Vec3& mirrorNormal) {
  const Vec3 axis = -reflected(Vec3(turn.x, turn.y, turn.z), bindNormal);
  const Vec3 across = glm::cross(mirrorNormal, bindNormal);
  const Quat between(-glm::dot(mirrorNormal, bindNormal), across.x, across.y, across.z);
  return between * Quat(turn.w, axis.x, axis.y, axis.z);
}

Vec3 leftOf(const Document& document) {
  const auto plane = sagittalPlaneOf(document, rig::bindPlaces(*document.scene).worlds);
  return plane ? plane->normal : Vec3(1.0, 0.0, 0.0);
}

/// About the vertical, from one way to the left to another one; both are level.
Quat turnBetweenLefts(const Vec3& from, const Vec3& to) {
  return axisAngle(Vec3(0.0, 1.0, 0.0), std::atan2(glm::cross(from, to).y, glm::dot(from, to)));
}

/// Heights of a character's controllers above its soles in the bind pose.
class RestHeights {
public:
  explicit RestHeights(const Document& document)
      : document_(document), places_(rig::bindPlaces(*document.scene)), sole_(soleHeight(document, places_)) {
  }

  [[nodiscard]] std::optional<double> of(const rig::Controller& controller) const {
    if (!sole_ || hangsOnItsLimb(controller.kind)) {
      return std::nullopt;
    }
    if (controller.node.exists()) {
      return positionOf(places_.worlds[at(controller.node)]).y - *sole_;
    }
    const rig::Limb* const limb = findLimb(document_, controller.limb);
    return limb == nullptr ? std::nullopt : std::optional(rig::endPosition(*limb, places_.worlds).y - *sole_);
  }

private:
  const Document& document_;
  rig::BindPlaces places_;
  std::optional<double> sole_;
};

double legLengthOf(const rig::ControllerList& list) {
  const rig::Controller* const hips = list.controller("hips");
  return hips == nullptr ? 1.0 : hips->length;
}

} // namespace

SeenPose seenPose(const SeenMoment& moment, std::span<const std::string> ids) {
  const rig::ControllerList list = controllersOf(moment.document);
  SeenPose pose;
  pose.of = moment.document.scene;
  pose.leftWorld = leftOf(moment.document);
  pose.leftOnItsWay = headingNormal(moment.document, moment.clip, moment.frame);
  pose.legLength = legLengthOf(list);
  const RestHeights rest(moment.document);
  for (const rig::PlacedController& placed : moment.placed) {
    if (placed.kind == rig::ControllerKind::hips) {
      pose.standingWorld = {placed.placeWorld.x, 0.0, placed.placeWorld.z};
    }
    const bool wanted = ids.empty() ? placed.kind != rig::ControllerKind::body
                                    : std::ranges::find(ids, placed.id) != ids.end();
    if (!wanted) {
      continue;
    }
    SeenController seen{placed.id, placed.placeWorld, placed.orientationWorld, std::nullopt};
    const rig::Controller* const controller = list.controller(placed.id);
    if (const std::optional<Vec3> base = baseOf(moment, controller)) {
      seen.fromBase = (placed.placeWorld - *base) / controller->length;
    }
    seen.restHeight = controller != nullptr ? rest.of(*controller) : std::nullopt;
    pose.controllers.push_back(std::move(seen));
  }
  return pose;
}

SeenPose mirroredPose(const Document& document, const SeenPose& pose) {
  SeenPose mirrored = pose;
  std::erase_if(mirrored.controllers, [&](SeenController& seen) {
    seen.id = otherSideOf(document, seen.id);
    seen.placeWorld = pose.standingWorld + reflected(seen.placeWorld - pose.standingWorld, pose.leftOnItsWay);
    seen.turnWorld = reflectedTurn(seen.turnWorld, pose.leftWorld, pose.leftOnItsWay);
    if (seen.fromBase) {
      seen.fromBase = reflected(*seen.fromBase, pose.leftOnItsWay);
    }
    return seen.id.empty();
  });
  std::erase_if(mirrored.values, [&](AttributeValue& value) {
    const std::string other = otherSideOf(document, value.id);
    value.id = other;
    return other.empty();
  });
  return mirrored;
}

SeenPose standardised(const SeenPose& pose) {
  SeenPose standard;
  const Quat facing = turnBetweenLefts(pose.leftWorld, standard.leftWorld);
  standard.leftOnItsWay = facing * pose.leftOnItsWay;
  standard.values = pose.values;
  for (SeenController seen : pose.controllers) {
    seen.placeWorld = facing * (seen.placeWorld - pose.standingWorld) / pose.legLength;
    seen.turnWorld = facing * seen.turnWorld * glm::inverse(facing);
    if (seen.fromBase) {
      seen.fromBase = facing * *seen.fromBase;
    }
    if (seen.restHeight) {
      seen.restHeight = *seen.restHeight / pose.legLength;
    }
    standard.controllers.push_back(std::move(seen));
  }
  return standard;
}

std::vector<SeenController> goalsOn(const SeenMoment& moment, const SeenPose& pose,
                                    const Vec3& standingWorld) {
  const rig::ControllerList list = controllersOf(moment.document);
  const bool sameCharacter = pose.of == moment.document.scene;
  const Quat facing = turnBetweenLefts(pose.leftWorld, leftOf(moment.document));
  const double scale = legLengthOf(list) / pose.legLength;
  const std::optional<RestHeights> rest =
      sameCharacter ? std::nullopt : std::optional<RestHeights>(std::in_place, moment.document);
  std::vector<SeenController> goals;
  for (SeenController goal : pose.controllers) {
    const auto placed = std::ranges::find(moment.placed, goal.id, &rig::PlacedController::id);
    if (placed == moment.placed.end()) {
      continue;
    }
    if (!sameCharacter) {
      const rig::Controller* const controller = list.controller(goal.id);
      const std::optional<Vec3> base = baseOf(moment, controller);
      goal.turnWorld = facing * goal.turnWorld * glm::inverse(facing);
      goal.placeWorld = base && goal.fromBase
                            ? *base + facing * *goal.fromBase * controller->length
                            : standingWorld + facing * (goal.placeWorld - pose.standingWorld) * scale;
      const std::optional<double> rests = controller != nullptr ? rest->of(*controller) : std::nullopt;
      if (rests && goal.restHeight) {
        goal.placeWorld.y += *rests - *goal.restHeight * scale; // As far from where it rests.
      }
    }
    goals.push_back(std::move(goal));
  }
  return goals;
}

} // namespace stretch::app

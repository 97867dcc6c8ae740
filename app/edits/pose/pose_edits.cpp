#include "app/edits/pose/pose_edits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>

#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/mirror_edits.h"
#include "core/anim/frames.h"
#include "rig/controllers/offset_curve.h"
#include "rig/reach/bind_places.h"

namespace stretch::app {

namespace {

constexpr std::string_view leftPrefix = "left-";
constexpr std::string_view rightPrefix = "right-";

bool isKnown(const rig::ControllerList& list, const std::string& id) {
  return list.controller(id) != nullptr || list.attribute(id) != nullptr;
}

/// "right-hand" of "left-hand"; the same where no side is named.
std::string withOtherSide(const std::string& id) {
  if (id.starts_with(leftPrefix)) {
    return std::string(rightPrefix) + id.substr(leftPrefix.size());
  }
  return id.starts_with(rightPrefix) ? std::string(leftPrefix) + id.substr(rightPrefix.size()) : id;
}

/// The joint that stands on the other side in the bind pose.
std::string jointOpposite(const Document& document, const rig::Controller& joint) {
  constexpr double nearEnough = 0.02; // heights
  const std::vector<Mat4> worlds = rig::bindPlaces(*document.scene).worlds;
  const std::optional<SagittalPlane> plane = sagittalPlaneOf(document, worlds);
  if (!plane) {
    return {};
  }
  const Vec3 here = positionOf(worlds[at(joint.node)]);
  const Vec3 there = here - 2.0 * glm::dot(here - plane->point, plane->normal) * plane->normal;
  std::string best;
  double nearest = nearEnough * document.body.height;
  for (const rig::Controller& other : jointControllersOf(document)) {
    const double distance = glm::length(positionOf(worlds[at(other.node)]) - there);
    if (distance < nearest) {
      nearest = distance;
      best = other.id;
    }
  }
  return best;
}

/// Length of the controller; nothing where the character lacks it.
std::optional<rig::Controller> knownController(const Document& document, const rig::ControllerList& list,
                                               const std::string& id) {
  Result<rig::Controller> found = findController(document, list, id);
  return found ? std::optional(std::move(found).value()) : std::nullopt;
}

struct KeysBeside {
  std::optional<double> before;
  std::optional<double> after;
};

KeysBeside keysBeside(const rig::OffsetCurve& curve, double timeSeconds, double sameSeconds) {
  KeysBeside beside;
  for (const double key : curve.keySeconds()) {
    if (key < timeSeconds - sameSeconds) {
      beside.before = key;
    } else if (key > timeSeconds + sameSeconds && !beside.after) {
      beside.after = key;
    }
  }
  return beside;
}

std::optional<rig::Offset> offsetBetween(const Document& document, const rig::Adjustment& adjustment,
                                         double frame, double standard, double between) {
  const double rate = clipOf(document, adjustment.clip).framesPerSecond;
  const rig::OffsetCurve curve(adjustment, standard, rate);
  const KeysBeside beside = keysBeside(curve, frame / rate, frameTolerance / rate);
  if (!beside.before || !beside.after) {
    return std::nullopt;
  }
  const rig::Offset from = curve.at(*beside.before);
  const rig::Offset to = curve.at(*beside.after);
  return rig::Offset{from.move + between * (to.move - from.move), from.turn + between * (to.turn - from.turn),
                     from.value + between * (to.value - from.value)};
}

} // namespace

std::vector<rig::Attribute> attributesHeldBy(const rig::ControllerList& list,
                                             const rig::Controller& controller) {
  using rig::ControllerKind;
  const bool isEnd = controller.kind == ControllerKind::hand || controller.kind == ControllerKind::foot ||
                     controller.kind == ControllerKind::tip || controller.kind == ControllerKind::head ||
                     controller.kind == ControllerKind::spineTop;
  std::vector<rig::Attribute> held;
  std::ranges::copy_if(list.attributes, std::back_inserter(held), [&](const rig::Attribute& attribute) {
    return isEnd && attribute.limb == controller.limb;
  });
  return held;
}

std::string otherSideOf(const Document& document, const std::string& id) {
  const rig::ControllerList list = controllersOf(document);
  if (isKnown(list, id)) {
    const std::string other = withOtherSide(id);
    return isKnown(list, other) ? other : std::string();
  }
  const std::optional<rig::Controller> joint = knownController(document, list, id);
  return joint ? jointOpposite(document, *joint) : std::string();
}

Result<OffsetPose> mirroredPose(const Document& document, int clip, double frame, const OffsetPose& pose) {
  const std::vector<Mat4> worlds = rig::bindPlaces(*document.scene).worlds;
  const std::optional<SagittalPlane> plane = sagittalPlaneOf(document, worlds);
  const Vec3 inBind = plane ? plane->normal : Vec3(1.0, 0.0, 0.0);
  const Vec3 inClip = sagittalNormal(document, clip, frame);
  OffsetPose mirrored;
  for (const ControllerOffset& offset : pose.offsets) {
    const std::string other = otherSideOf(document, offset.id);
    if (other.empty()) {
      return Error{"has no other side", offset.id, "take it out of the selection"};
    }
    const Vec3& normal = offset.id == "body" || offset.id == "hips" ? inClip : inBind;
    mirrored.offsets.push_back({other, reflected(offset.move, normal), -reflected(offset.turn, normal)});
  }
  for (const AttributeValue& value : pose.values) {
    if (const std::string other = otherSideOf(document, value.id); !other.empty()) {
      mirrored.values.push_back({other, value.value});
    }
  }
  return mirrored;
}

OffsetPose inLengths(const Document& document, const OffsetPose& pose) {
  const rig::ControllerList list = controllersOf(document);
  OffsetPose counted{{}, pose.values};
  for (const ControllerOffset& offset : pose.offsets) {
    if (const auto controller = knownController(document, list, offset.id); controller) {
      counted.offsets.push_back({offset.id, offset.move / controller->length, offset.turn});
    }
  }
  return counted;
}

OffsetPose inWorldUnits(const Document& document, const OffsetPose& pose) {
  const rig::ControllerList list = controllersOf(document);
  OffsetPose fitting;
  for (const ControllerOffset& offset : pose.offsets) {
    if (const auto controller = knownController(document, list, offset.id); controller) {
      fitting.offsets.push_back({offset.id, controller->moves ? offset.move * controller->length : Vec3(0.0),
                                 controller->turns ? offset.turn : Vec3(0.0)});
    }
  }
  std::ranges::copy_if(pose.values, std::back_inserter(fitting.values),
                       [&](const AttributeValue& value) { return list.attribute(value.id) != nullptr; });
  return fitting;
}

OffsetPose tweenedPose(const Document& document, int clip, double frame, std::span<const std::string> ids,
                       double between) {
  const rig::ControllerList list = controllersOf(document);
  OffsetPose tweened;
  for (const std::string& id : ids) {
    const rig::Attribute* const attribute = list.attribute(id);
    const rig::Adjustment* const adjustment = adjustmentAt(document, clip, frame, id);
    const double standard = attribute == nullptr ? 0.0 : attribute->standard;
    const std::optional<rig::Offset> offset =
        adjustment == nullptr ? std::nullopt : offsetBetween(document, *adjustment, frame, standard, between);
    if (offset && attribute == nullptr) {
      tweened.offsets.push_back({id, offset->move, offset->turn});
    } else if (offset) {
      tweened.values.push_back({id, std::clamp(offset->value, attribute->minimum, attribute->maximum)});
    }
  }
  return tweened;
}

} // namespace stretch::app

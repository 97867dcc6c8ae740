#include "app/commands/pose/held_controllers.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/rotation.h"
#include "rig/ik/spline_spine.h"

namespace stretch::app {

namespace {

// A foot stays where it is put, whatever its leg hangs on.
bool carries(const rig::PlacedController& carrier, const rig::PlacedController& other) {
  using rig::ControllerKind;
  const bool goesAlong = other.carrier != rig::Carrier::scene && other.kind != ControllerKind::foot;
  switch (carrier.kind) {
  case ControllerKind::body:
    return other.kind != ControllerKind::body;
  case ControllerKind::hips:
    return goesAlong || other.kind == ControllerKind::pole;
  case ControllerKind::spineTop:
    return goesAlong && other.carrier == rig::Carrier::chest;
  default:
    return false;
  }
}

} // namespace

Vec3 turnedFurther(const Vec3& vector, const Vec3& change) {
  if (glm::length(vector) <= 0.0) {
    return change;
  }
  Quat sum = glm::normalize(rig::rotationOfVector(change) * rig::rotationOfVector(vector));
  sum = sum.w < 0.0 ? -sum : sum;
  const Vec3 sine(sum.x, sum.y, sum.z);
  const double length = glm::length(sine);
  const Vec3 expected = vector + change;
  const Vec3 axis = length > 1e-12                  ? sine / length
                    : glm::length(expected) > 1e-12 ? glm::normalize(expected)
                                                    : Vec3(0.0, 1.0, 0.0);
  const double angle = 2.0 * std::atan2(length, sum.w);
  const double turns = std::round((glm::dot(expected, axis) - angle) / (2.0 * pi));
  return (angle + 2.0 * pi * turns) * axis;
}

std::vector<HeldController> heldControllers(PullMotion motion,
                                            std::span<const rig::PlacedController> selected,
                                            std::span<const ControllerOffset> offsets) {
  std::vector<HeldController> held;
  for (std::size_t i = 0; i < selected.size(); ++i) {
    const rig::PlacedController& one = selected[i];
    const bool moves = motion == PullMotion::move;
    const bool isCarried = std::ranges::any_of(
        selected, [&](const rig::PlacedController& other) { return carries(other, one); });
    if ((moves && one.moves && !isCarried) || (!moves && one.turns)) {
      held.push_back({one, offsets[i]});
    }
  }
  return held;
}

std::vector<ControllerOffset> changedOffsets(const PullModal& modal, std::span<const HeldController> held) {
  std::vector<ControllerOffset> changed;
  for (const HeldController& one : held) {
    const Mat3& axes = one.placed.carrierAxesWorld;
    const Vec3 change = glm::transpose(axes) * worldChange(modal, axes);
    ControllerOffset offset = one.offset;
    if (change != Vec3(0.0) && modal.motion == PullMotion::move) {
      offset.move += one.placed.slack + change;
    } else if (change != Vec3(0.0)) {
      offset.turn = turnedFurther(offset.turn, change);
    }
    changed.push_back(offset);
  }
  return changed;
}

} // namespace stretch::app

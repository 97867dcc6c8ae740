#include "app/commands/pose/controller_modal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/rotation.h"
#include "rig/ik/spline_spine.h"

namespace stretch::app {

namespace {

constexpr double degree = pi / 180.0;

// From free to an axis of the world, to the same of the carrier, to free.
void pressAxis(AxisLock& lock, int axis, bool plane) {
  const bool same = lock.axis == axis && lock.plane == plane;
  if (same && !lock.ofCarrier) {
    lock.ofCarrier = true;
  } else {
    lock = same ? AxisLock{} : AxisLock{axis, plane, false};
  }
}

Vec3 axisOfLock(const AxisLock& lock, const Mat3& carrierAxes) {
  const Mat3 axes = lock.ofCarrier ? carrierAxes : Mat3(1.0);
  return axes[lock.axis.value_or(0)];
}

Vec3 movedBy(const ControllerModal& modal, const Mat3& carrierAxes) {
  const std::optional<Vec3> axis = lockedAxis(modal.lock, carrierAxes);
  if (!modal.typed.empty()) {
    return modal.typed.value() * axis.value_or(modal.viewAxes[0]);
  }
  const Vec3 free = modal.mouseWorld + modal.arrowsWorld;
  if (!modal.lock.axis) {
    return free;
  }
  const Vec3 locked = axisOfLock(modal.lock, carrierAxes);
  const Vec3 along = glm::dot(free, locked) * locked;
  return modal.lock.plane ? free - along : along;
}

double turnedRadians(const ControllerModal& modal) {
  return modal.typed.empty() ? modal.mouseRadians : modal.typed.value() * degree;
}

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

void pressArrow(ControllerModal& modal, const Chord& chord) {
  if (modal.motion == ControllerMotion::move) {
    modal.arrowsWorld += nudgeOf(chord, modal.viewAxes, modal.arrowUnits);
    return;
  }
  const double step = degree * (chord.shift ? 10.0 : chord.ctrl ? 0.1 : 1.0);
  const bool on = chord.key == Key::right || chord.key == Key::up;
  const bool back = chord.key == Key::left || chord.key == Key::down;
  modal.mouseRadians += on ? step : back ? -step : 0.0;
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

ModalOutcome pressKey(ControllerModal& modal, const KeyPress& press) {
  const Chord& chord = press.chord;
  if (const std::optional<ModalOutcome> end = endBy(chord)) {
    return *end;
  }
  const bool plain = !chord.ctrl && !chord.alt;
  if (plain && typeNumber(modal.typed, chord)) {
    return ModalOutcome::running;
  }
  if (const std::optional<int> axis = plain ? axisOf(typedLetter(press)) : std::nullopt) {
    pressAxis(modal.lock, *axis, chord.shift && modal.motion == ControllerMotion::move);
  } else {
    pressArrow(modal, chord);
  }
  return ModalOutcome::running;
}

std::optional<Vec3> lockedAxis(const AxisLock& lock, const Mat3& carrierAxes) {
  return lock.axis && !lock.plane ? std::optional(axisOfLock(lock, carrierAxes)) : std::nullopt;
}

Vec3 worldChange(const ControllerModal& modal, const Mat3& carrierAxes) {
  if (modal.motion == ControllerMotion::move) {
    return movedBy(modal, carrierAxes);
  }
  return turnedRadians(modal) * lockedAxis(modal.lock, carrierAxes).value_or(modal.viewAxes[2]);
}

std::vector<HeldController> heldControllers(ControllerMotion motion,
                                            std::span<const rig::PlacedController> selected,
                                            std::span<const ControllerOffset> offsets) {
  std::vector<HeldController> held;
  for (std::size_t i = 0; i < selected.size(); ++i) {
    const rig::PlacedController& one = selected[i];
    const bool moves = motion == ControllerMotion::move;
    const bool isCarried = std::ranges::any_of(
        selected, [&](const rig::PlacedController& other) { return carries(other, one); });
    if ((moves && one.moves && !isCarried) || (!moves && one.turns)) {
      held.push_back({one, offsets[i]});
    }
  }
  return held;
}

std::vector<ControllerOffset> changedOffsets(const ControllerModal& modal,
                                             std::span<const HeldController> held) {
  std::vector<ControllerOffset> changed;
  for (const HeldController& one : held) {
    const Mat3& axes = one.placed.carrierAxesWorld;
    const Vec3 change = glm::transpose(axes) * worldChange(modal, axes);
    ControllerOffset offset = one.offset;
    if (change != Vec3(0.0) && modal.motion == ControllerMotion::move) {
      offset.move += one.placed.slack + change;
    } else if (change != Vec3(0.0)) {
      offset.turn = turnedFurther(offset.turn, change);
    }
    changed.push_back(offset);
  }
  return changed;
}

std::string modalText(const ControllerModal& modal, const std::string& title) {
  const bool moves = modal.motion == ControllerMotion::move;
  const std::string axes = modal.lock.axis
                               ? std::string(1, axisNames[static_cast<std::size_t>(*modal.lock.axis)]) +
                                     (modal.lock.ofCarrier ? " of its carrier" : "")
                               : std::string();
  if (!moves) {
    const std::string about = modal.lock.axis ? " about " + axes : std::string();
    return fmt::format("{} turned{} by {:.1f}°", title, about, turnedRadians(modal) / degree);
  }
  const Vec3 change = worldChange(modal, Mat3(1.0));
  if (modal.lock.axis && !modal.lock.plane) {
    const double amount = change[*modal.lock.axis];
    return fmt::format("{} moved along {} by {:.3f}", title, axes, amount);
  }
  const std::string lock = modal.lock.axis ? " without " + axes : std::string();
  return fmt::format("{} moved{} by {:.3f} {:.3f} {:.3f}", title, lock, change.x, change.y, change.z);
}

std::vector<ModalHint> modalHints(const ControllerModal& modal) {
  const bool moves = modal.motion == ControllerMotion::move;
  return {{"Enter", "keep"},
          {"Esc", "restore"},
          {"Mouse", moves ? (modal.lock.axis ? "along the axis" : "in the view plane") : "turn"},
          {"X Y Z", "lock an axis, twice the carrier's"},
          {"0-9", moves ? "amount" : "degrees"}};
}

} // namespace stretch::app

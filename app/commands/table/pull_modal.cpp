#include "app/commands/table/pull_modal.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace stretch::app {

namespace {

constexpr double degree = pi / 180.0;

// From free to an axis of the world, to the same of the carrier, to free.
void pressAxis(PullModal& modal, int axis, bool plane) {
  AxisLock& lock = modal.lock;
  const bool same = lock.axis == axis && lock.plane == plane;
  if (same && !lock.ofCarrier && modal.hasCarriers) {
    lock.ofCarrier = true;
  } else {
    lock = same ? AxisLock{} : AxisLock{axis, plane, false};
  }
}

Vec3 axisOfLock(const AxisLock& lock, const Mat3& carrierAxes) {
  const Mat3 axes = lock.ofCarrier ? carrierAxes : Mat3(1.0);
  return axes[lock.axis.value_or(0)];
}

// Where a typed amount goes in the plane beside the locked axis: to the right as it is seen, or up where the
// locked axis points to the right.
Vec3 typedDirection(const PullModal& modal, const Vec3& locked) {
  const Vec3 right = modal.viewAxes[0] - glm::dot(modal.viewAxes[0], locked) * locked;
  const Vec3 up = modal.viewAxes[1] - glm::dot(modal.viewAxes[1], locked) * locked;
  return glm::normalize(glm::length(right) > 0.5 ? right : up);
}

Vec3 movedBy(const PullModal& modal, const Mat3& carrierAxes) {
  const std::optional<Vec3> axis = lockedAxis(modal.lock, carrierAxes);
  const bool isTyped = !modal.typed.empty();
  if (axis && isTyped) {
    return modal.typed.value() * *axis;
  }
  const Vec3 free = isTyped ? modal.typed.value() * modal.viewAxes[0] : modal.mouseWorld + modal.arrowsWorld;
  if (!modal.lock.axis) {
    return free;
  }
  const Vec3 locked = axisOfLock(modal.lock, carrierAxes);
  if (isTyped) { // in a plane: along an axis it was answered above
    return modal.typed.value() * typedDirection(modal, locked);
  }
  const Vec3 along = glm::dot(free, locked) * locked;
  return modal.lock.plane ? free - along : along;
}

double turnedRadians(const PullModal& modal) {
  return modal.typed.empty() ? modal.mouseRadians : modal.typed.value() * degree;
}

void pressArrow(PullModal& modal, const Chord& chord) {
  if (modal.motion == PullMotion::move) {
    modal.arrowsWorld += nudgeOf(chord, modal.viewAxes, modal.arrowUnits);
    return;
  }
  const double step = degree * (chord.shift ? 10.0 : chord.ctrl ? 0.1 : 1.0);
  const bool on = chord.key == Key::right || chord.key == Key::up;
  const bool back = chord.key == Key::left || chord.key == Key::down;
  modal.mouseRadians += on ? step : back ? -step : 0.0;
}

} // namespace

ModalOutcome pressKey(PullModal& modal, const KeyPress& press) {
  const Chord& chord = press.chord;
  if (const std::optional<ModalOutcome> end = endBy(chord)) {
    return *end;
  }
  const bool plain = !chord.ctrl && !chord.alt;
  if (plain && typeNumber(modal.typed, chord)) {
    return ModalOutcome::running;
  }
  if (const std::optional<int> axis = plain ? axisOf(typedLetter(press)) : std::nullopt) {
    pressAxis(modal, *axis, chord.shift && modal.motion == PullMotion::move);
  } else {
    pressArrow(modal, chord);
  }
  return ModalOutcome::running;
}

std::optional<Vec3> lockedAxis(const AxisLock& lock, const Mat3& carrierAxes) {
  return lock.axis && !lock.plane ? std::optional(axisOfLock(lock, carrierAxes)) : std::nullopt;
}

Vec3 worldChange(const PullModal& modal, const Mat3& carrierAxes) {
  if (modal.motion == PullMotion::move) {
    return movedBy(modal, carrierAxes);
  }
  return turnedRadians(modal) * lockedAxis(modal.lock, carrierAxes).value_or(modal.viewAxes[2]);
}

std::string modalText(const PullModal& modal, const std::string& title) {
  const bool moves = modal.motion == PullMotion::move;
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

std::vector<ModalHint> modalHints(const PullModal& modal) {
  const bool moves = modal.motion == PullMotion::move;
  return {{"Enter", "keep"},
          {"Esc", "restore"},
          {"Mouse", moves ? (modal.lock.axis ? "along the axis" : "in the view plane") : "turn"},
          {"X Y Z", modal.hasCarriers ? "lock an axis, twice the carrier's" : "lock an axis"},
          {"0-9", moves ? "amount" : "degrees"}};
}

} // namespace stretch::app

#include "app/commands/table/grab_modal.h"

#include <glm/geometric.hpp>

#include <fmt/format.h>

namespace stretch::app {

namespace {

void lockAxis(GrabModal& modal, int axis, bool plane) {
  const bool same = modal.axis == axis && modal.plane == plane;
  modal.axis = same ? std::nullopt : std::optional(axis);
  modal.plane = !same && plane;
}

Vec3 typedDirection(const GrabModal& modal) {
  return modal.axis && !modal.plane ? axisVector(*modal.axis) : modal.viewAxes[0];
}

} // namespace

GrabModal beginGrab(const Mat3& viewAxes, double arrowUnits) {
  GrabModal modal;
  modal.viewAxes = viewAxes;
  modal.arrowUnits = arrowUnits;
  return modal;
}

ModalOutcome pressKey(GrabModal& modal, const KeyPress& press) {
  const Chord& chord = press.chord;
  if (const std::optional<ModalOutcome> end = endBy(chord)) {
    return *end;
  }
  const bool plain = !chord.ctrl && !chord.alt;
  if (plain && typeNumber(modal.typed, chord)) {
    return ModalOutcome::running;
  }
  const std::optional<int> axis = plain ? axisOf(typedLetter(press)) : std::nullopt;
  if (axis) {
    lockAxis(modal, *axis, chord.shift);
  } else {
    modal.arrowsWorld += nudgeOf(chord, modal.viewAxes, modal.arrowUnits);
  }
  return ModalOutcome::running;
}

Vec3 grabDelta(const GrabModal& modal) {
  if (!modal.typed.empty()) {
    return modal.typed.value() * typedDirection(modal);
  }
  const Vec3 free = modal.mouseWorld + modal.arrowsWorld;
  if (!modal.axis) {
    return free;
  }
  const Vec3 axis = axisVector(*modal.axis);
  const Vec3 along = glm::dot(free, axis) * axis;
  return modal.plane ? free - along : along;
}

std::string modalText(const GrabModal& modal, std::size_t sphereCount) {
  const std::string what = sphereCount == 0   ? "tangent"
                           : sphereCount == 1 ? "sphere"
                                              : fmt::format("{} spheres", sphereCount);
  if (modal.axis && !modal.plane) {
    const auto axis = static_cast<std::size_t>(*modal.axis);
    return fmt::format("{} along {} {:.3f}", what, axisNames[axis], grabDelta(modal)[axis]);
  }
  const Vec3 delta = grabDelta(modal);
  const std::string lock = modal.axis
                               ? fmt::format(" without {}", axisNames[static_cast<std::size_t>(*modal.axis)])
                               : std::string();
  return fmt::format("{} moved{} by {:.3f} {:.3f} {:.3f}", what, lock, delta.x, delta.y, delta.z);
}

std::vector<ModalHint> modalHints(const GrabModal& modal) {
  return {{"Enter", "keep"},
          {"Esc", "restore"},
          {"Mouse", modal.axis ? "along the axis" : "in the view plane"},
          {"X Y Z", "lock an axis"},
          {"0-9", "amount"},
          {"Wheel", "falloff"}};
}

} // namespace stretch::app

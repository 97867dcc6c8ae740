#include "app/commands/grab_modal.h"

#include <glm/geometric.hpp>

#include <fmt/format.h>

namespace stretch::app {

namespace {

constexpr char axisNames[] = {'X', 'Y', 'Z'};

Vec3 axisVector(int axis) {
  Vec3 vector(0.0);
  vector[static_cast<std::size_t>(axis)] = 1.0;
  return vector;
}

std::optional<int> axisOf(char letter) {
  return letter >= 'x' && letter <= 'z' ? std::optional(letter - 'x') : std::nullopt;
}

bool typeAmount(GrabModal& modal, const Chord& chord) {
  std::string& text = modal.typed.text;
  const std::optional<int> digit = digitOf(chord.key);
  if (digit && text.size() < 9) {
    text.push_back(static_cast<char>('0' + *digit));
  } else if (isDecimalSeparator(chord.key)) {
    if (text.find('.') == std::string::npos) {
      text.push_back('.');
    }
  } else if (chord.key == Key::minus) {
    text = !text.empty() && text.front() == '-' ? text.substr(1) : "-" + text;
  } else if (chord.key == Key::backspace) {
    text = text.empty() ? text : text.substr(0, text.size() - 1);
  } else {
    return digit.has_value();
  }
  return true;
}

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
  if (chord.key == Key::enter || chord.key == Key::numpadEnter) {
    return ModalOutcome::keep;
  }
  if (chord.key == Key::escape) {
    return ModalOutcome::restore;
  }
  const bool plain = !chord.ctrl && !chord.alt;
  if (plain && typeAmount(modal, chord)) {
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

Vec3 nudgeOf(const Chord& chord, const Mat3& viewAxes, double stepUnits) {
  const double step = stepUnits * (chord.shift ? 10.0 : chord.ctrl ? 0.1 : 1.0);
  switch (chord.key) {
  case Key::right:
    return step * viewAxes[0];
  case Key::left:
    return -step * viewAxes[0];
  case Key::up:
    return step * viewAxes[1];
  case Key::down:
    return -step * viewAxes[1];
  case Key::pageDown:
    return step * viewAxes[2];
  case Key::pageUp:
    return -step * viewAxes[2];
  default:
    return Vec3(0.0);
  }
}

} // namespace stretch::app

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/modal.h"
#include "core/math/types.h"

namespace stretch::app {

/// The modal behind G: moves the selected control spheres. Pure state: keys and mouse in, a world vector out.
struct GrabModal {
  Mat3 viewAxes{1.0};      ///< World columns: right, up, towards the viewer.
  double arrowUnits = 0.0; ///< World units that one arrow key moves; Shift ten times, Ctrl a tenth.
  Vec3 mouseWorld{0.0};    ///< Way that the mouse has pulled, in the view plane.
  Vec3 arrowsWorld{0.0};   ///< Gathered by the arrow keys.
  std::optional<int> axis; ///< 0 x, 1 y, 2 z of the world.
  bool plane = false;      ///< `axis` is what is left out.
  TypedNumber typed;       ///< Replaces mouse and arrows when it is not empty: along the axis, else along the
                           ///< view's right.
};

[[nodiscard]] GrabModal beginGrab(const Mat3& viewAxes, double arrowUnits);

/// X, Y, Z lock an axis (again: free; with Shift: the other two); digits, period or comma, minus and
/// Backspace type an amount; arrows, Page Up and Page Down move; Enter keeps, Esc restores.
[[nodiscard]] ModalOutcome pressKey(GrabModal& modal, const KeyPress& press);

/// How far the spheres are pulled, world units.
[[nodiscard]] Vec3 grabDelta(const GrabModal& modal);

/// "2 spheres along X 0.200"; for no sphere it is a tangent that is pulled.
[[nodiscard]] std::string modalText(const GrabModal& modal, std::size_t sphereCount);
[[nodiscard]] std::vector<ModalHint> modalHints(const GrabModal& modal);

} // namespace stretch::app

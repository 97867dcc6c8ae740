#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/modal.h"
#include "app/edits/pose/offset_edits.h"
#include "core/math/types.h"
#include "rig/motion/controller_places.h"

namespace stretch::app {

enum class ControllerMotion { move, turn };

/// Along or about which axes a modal acts.
struct AxisLock {
  std::optional<int> axis; ///< 0 x, 1 y, 2 z; none: free.
  bool plane = false;      ///< `axis` is what is left out.
  bool ofCarrier = false;  ///< Along the axes of each controller's carrier, not of the world.

  friend bool operator==(const AxisLock&, const AxisLock&) = default;
};

/// The modal behind G and R while controllers are selected, and behind their handles. Pure state: keys and
/// mouse in, offsets out.
struct ControllerModal {
  ControllerMotion motion = ControllerMotion::move;
  Mat3 viewAxes{1.0};        ///< World columns: right, up, towards the viewer.
  double arrowUnits = 0.0;   ///< World units that one arrow key moves, Shift ten times, Ctrl a tenth.
  Vec3 mouseWorld{0.0};      ///< Way that the mouse has pulled.
  Vec3 arrowsWorld{0.0};     ///< Gathered by the arrow keys.
  double mouseRadians = 0.0; ///< How far the mouse has turned; may be more than a turn.
  AxisLock lock;
  TypedNumber typed; ///< Replaces mouse and arrows when it is not empty: units or degrees; without a lock
                     ///< along the view's right, or about the direction to the viewer.
};

/// X, Y, Z lock an axis of the world, a second time of the carrier, a third time nothing (with Shift: the
/// other two, when moving); digits, period or comma, minus and Backspace type an amount; arrows, Page Up and
/// Page Down move, or turn by a degree; Enter keeps, Esc restores.
[[nodiscard]] ModalOutcome pressKey(ControllerModal& modal, const KeyPress& press);

/// A turn (a rotation vector) on top of another one along the same axes: of all vectors that turn so the one
/// nearest to their sum, so that turns beyond the half one count on.
[[nodiscard]] Vec3 turnedFurther(const Vec3& vector, const Vec3& change);

/// Which way a controller whose carrier has these axes is moved (world units), or turned (a rotation vector),
/// in the world.
[[nodiscard]] Vec3 worldChange(const ControllerModal& modal, const Mat3& carrierAxes);

/// The axis of the world that is locked, of a carrier with these axes; none when free or locked to a plane.
[[nodiscard]] std::optional<Vec3> lockedAxis(const AxisLock& lock, const Mat3& carrierAxes);

/// A controller that a modal has hold of, as it was when that began.
struct HeldController {
  rig::PlacedController placed;
  ControllerOffset offset;
};

/// Takes hold of those that can do the motion; of two of which one carries the other only that one moves.
[[nodiscard]] std::vector<HeldController> heldControllers(ControllerMotion motion,
                                                          std::span<const rig::PlacedController> selected,
                                                          std::span<const ControllerOffset> offsets);

/// Returns the offsets as the modal changes them: moved together, turned each about its own place.
[[nodiscard]] std::vector<ControllerOffset> changedOffsets(const ControllerModal& modal,
                                                           std::span<const HeldController> held);

/// "left hand moved along Y -0.100", "2 controllers turned about X 45.0 deg".
[[nodiscard]] std::string modalText(const ControllerModal& modal, const std::string& title);
[[nodiscard]] std::vector<ModalHint> modalHints(const ControllerModal& modal);

} // namespace stretch::app

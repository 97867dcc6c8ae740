#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/modal.h"
#include "core/math/types.h"

namespace stretch::app {

enum class PullMotion { move, turn };

/// Along or about which axes a modal acts.
struct AxisLock {
  std::optional<int> axis; ///< 0 x, 1 y, 2 z; none: free.
  bool plane = false;      ///< `axis` is what is left out.
  bool ofCarrier = false;  ///< Along the axes of each controller's carrier, not of the world.

  friend bool operator==(const AxisLock&, const AxisLock&) = default;
};

/// The modal behind G and R, and behind handles: pulls control spheres and tangents, pulls and turns
/// controllers and locators. Pure state: keys and mouse in, a change in the world out.
struct PullModal {
  PullMotion motion = PullMotion::move;
  bool hasCarriers = true;   ///< An axis that is locked twice is the carrier's; else it is free again.
  Mat3 viewAxes{1.0};        ///< World columns: right, up, towards the viewer.
  double arrowUnits = 0.0;   ///< World units that one arrow key moves; Shift ten times, Ctrl a tenth.
  Vec3 mouseWorld{0.0};      ///< Way that the mouse has pulled.
  Vec3 arrowsWorld{0.0};     ///< Gathered by the arrow keys.
  double mouseRadians = 0.0; ///< How far the mouse has turned; may be more than a turn.
  AxisLock lock;
  TypedNumber typed; ///< Replaces mouse and arrows when it is not empty: units or degrees; without a lock
                     ///< along the view's right, or about the direction to the viewer.
};

/// X, Y, Z lock an axis of the world, a second time of the carrier where there is one, and then nothing (with
/// Shift: the other two, when moving); digits, period or comma, minus and Backspace type an amount; arrows,
/// Page Up and Page Down move, or turn by a degree; Enter keeps, Esc restores.
[[nodiscard]] ModalOutcome pressKey(PullModal& modal, const KeyPress& press);

/// Which way something whose carrier has these axes is moved (world units), or turned (a rotation vector), in
/// the world.
[[nodiscard]] Vec3 worldChange(const PullModal& modal, const Mat3& carrierAxes = Mat3(1.0));

/// The axis of the world that is locked, of a carrier with these axes; none when free or locked to a plane.
[[nodiscard]] std::optional<Vec3> lockedAxis(const AxisLock& lock, const Mat3& carrierAxes);

/// "left hand moved along Y by -0.100", "2 controllers turned about X by 45.0°".
[[nodiscard]] std::string modalText(const PullModal& modal, const std::string& title);
[[nodiscard]] std::vector<ModalHint> modalHints(const PullModal& modal);

} // namespace stretch::app

#pragma once

#include <span>
#include <vector>

#include "app/commands/table/pull_modal.h"
#include "app/edits/pose/offset_edits.h"
#include "rig/motion/controller_places.h"

namespace stretch::app {

/// A controller that a modal has hold of, as it was when that began.
struct HeldController {
  rig::PlacedController placed;
  ControllerOffset offset;
};

/// A turn (a rotation vector) on top of another one along the same axes: of all vectors that turn so the one
/// nearest to their sum, so that turns beyond the half one count on.
[[nodiscard]] Vec3 turnedFurther(const Vec3& vector, const Vec3& change);

/// Takes hold of those that can do the motion; of two of which one carries the other only that one moves.
[[nodiscard]] std::vector<HeldController> heldControllers(PullMotion motion,
                                                          std::span<const rig::PlacedController> selected,
                                                          std::span<const ControllerOffset> offsets);

/// Returns the offsets as the modal changes them: moved together, turned each about its own place.
[[nodiscard]] std::vector<ControllerOffset> changedOffsets(const PullModal& modal,
                                                           std::span<const HeldController> held);

} // namespace stretch::app

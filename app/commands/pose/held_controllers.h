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

/// Takes hold of those that can do the motion; of two of which one carries the other only that one moves.
[[nodiscard]] std::vector<HeldController> heldControllers(PullMotion motion,
                                                          std::span<const rig::PlacedController> selected,
                                                          std::span<const ControllerOffset> offsets);

/// Returns the offsets as the modal changes them: moved together, turned each about its own place.
[[nodiscard]] std::vector<ControllerOffset> changedOffsets(const PullModal& modal,
                                                           std::span<const HeldController> held);

} // namespace stretch::app

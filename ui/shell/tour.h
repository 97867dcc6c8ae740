#pragma once

#include <optional>

#include "ui/shell/shell.h"

namespace stretch::ui {

/// Begins the tour on the bundled punch, which is opened first where something else is.
Status startTour(Shell& shell);
void endTour(Shell& shell);
[[nodiscard]] bool isOnTour(const Shell& shell);

/// A character was opened: the tour begins if it was not shown yet and this is the bundled punch.
void offerTour(Shell& shell);

/// Once a frame: goes on when the user has done what the step asks for.
void updateTour(Shell& shell);

/// Esc ends the tour while no tool runs. False: the key is not meant.
bool pressTourKey(Shell& shell, const app::KeyPress& press);

/// The step that is shown; none while the tour does not run or another file is open.
[[nodiscard]] std::optional<TourCard> tourCard(const Shell& shell);

} // namespace stretch::ui

#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

/// The mouse in the viewport for one frame, as Dear ImGui tells it: navigation, picking, dragging spheres,
/// box selection. `hovered`: nothing lies above the picture; `held`: a button that was pressed over it is
/// still down.
void handleViewportMouse(Shell& shell, bool hovered, bool held);

/// What lies under the mouse, for highlights and for the next press.
void updateHover(Shell& shell);

} // namespace stretch::ui

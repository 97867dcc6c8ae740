#pragma once

#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

/// The mouse in the viewport for one frame, as Dear ImGui tells it: navigation, picking, dragging spheres,
/// box selection. `hovered`: nothing lies above the picture; `held`: a button that was pressed over it is
/// still down.
void handleViewportMouse(ViewportContext& context, bool hovered, bool held);

/// Finds what lies under the mouse, for highlights and for the next press.
void updateHover(ViewportContext& context);

} // namespace stretch::ui

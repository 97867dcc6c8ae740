#pragma once

#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

// The mouse on controllers and their handles. What is under it stands in ViewportState::hoveredHandle and
// hoveredController.

void hoverHandles(ViewportContext& context);
void hoverControllers(ViewportContext& context);

/// While controllers are moved or turned the handle of the locked axis is the one that counts as held.
void markHeldHandle(ViewportState& viewport, const ControllerTool& tool);

/// A press with the left button: takes the handle, or selects the controller. False where neither is under
/// the mouse.
bool pressController(ViewportContext& context, bool add);

/// A press that became a drag: of a controller without a handle in the view plane, or of a hand, foot or head
/// while controllers are shown. False where it is neither.
bool dragController(ViewportContext& context);

/// Selects the controllers in a rectangle, pixels. False where none are shown or a trail is selected, whose
/// spheres are meant then.
bool selectControllersInBox(ViewportContext& context, const Vec2& low, const Vec2& high, bool add);

} // namespace stretch::ui

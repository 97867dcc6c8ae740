#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.h"
#include "ui/panels/state/ui_state.h"
#include "ui/render/overlay/controller_drawing.h"
#include "ui/render/picture/controller_handles.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// A controller as the viewport shows it.
struct ShownController {
  rig::PlacedController placed;
  ControllerPicture picture; ///< Neither selected nor hovered.
};

/// Ids of what is selected of the locators while they are shown, else of the controllers.
[[nodiscard]] const std::vector<std::string>& selectedHandles(const app::Session& session);

/// Whether controllers are shown: they are switched on, or one is selected.
[[nodiscard]] bool showsControllers(const app::Session& session, const ViewportOverlays& overlays);

/// The locators while they are shown. Else controllers: those of the body, and with the skeleton those on
/// other joints, as they stand at the playhead; none while they are not shown. A selected one is always
/// there.
[[nodiscard]] std::vector<ShownController> shownControllers(app::Session& session,
                                                            const ViewportOverlays& overlays);

/// The controller under the mouse: the nearest line, knob or ring within 20 points.
[[nodiscard]] std::optional<std::string>
pickController(const View& view, const std::vector<ShownController>& shown, const Vec2& mousePixels);

/// Those that stand in a rectangle of the screen, pixels.
[[nodiscard]] std::vector<std::string> controllersInBox(const View& view,
                                                        const std::vector<ShownController>& shown,
                                                        const Vec2& low, const Vec2& high);

/// At the last selected one; nothing when none is selected.
[[nodiscard]] std::optional<ControllerHandles> controllerHandles(const app::Session& session,
                                                                 const std::vector<ShownController>& shown);

/// Returns the controllers that are drawn, with what is selected and under the mouse. Rings of joints that
/// stand close together, as in a hand, leave each other room.
[[nodiscard]] std::vector<ControllerPicture> controllerPictures(const std::vector<ShownController>& shown,
                                                                const std::vector<std::string>& selected,
                                                                const std::string& hovered);

/// Null when it is not shown.
[[nodiscard]] const ShownController* findShown(const std::vector<ShownController>& shown,
                                               const std::string& id);

} // namespace stretch::ui

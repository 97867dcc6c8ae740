#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/pose/held_controllers.h"
#include "app/session.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// What the mouse and the keys do to things in the viewport: by G or R until Enter or a click, or by a drag
/// of the mouse until it lets go.
struct Pull {
  app::PullModal modal;
  bool byDrag = false;   ///< Letting the mouse button go keeps it.
  Vec3 anchor{0.0};      ///< The point that is held, or turned about; world.
  Vec2 startPixels{0.0}; ///< Place of the mouse, in the viewport.
  Vec2 lastPixels{0.0};
  bool moved = false; ///< The mouse left its place: a click is no drag.
};

/// Follows the mouse; `axes` are the carrier's, which a lock may name. False while it has not left its place.
bool followMouse(Pull& pull, const Mat3& axes, const View& view, const Vec2& mousePixels);

/// Moving or turning controllers or locators.
struct ControllerTool : Pull {
  std::vector<app::HeldController> held; ///< Controllers as they were at the beginning.
  std::string title;                     ///< "left hand", "2 controllers".
  app::UnkeyedPose unkeyed;              ///< At the beginning.
  bool isOfLocators = false;             ///< Whether locators are held, which have no keys.
};

struct ControllerStart {
  app::PullMotion motion = app::PullMotion::move;
  app::AxisLock lock; ///< From the beginning: a handle was taken.
  Vec2 startPixels{0.0};
  bool byDrag = false;
};

/// Takes hold of the selected controllers, or of the selected locators while those are shown. An error says
/// why none of them can do the motion.
[[nodiscard]] Result<ControllerTool> startControllers(app::Session& session, const ControllerStart& start);

/// Shows what the modal makes of them: keyed, or while auto-key is off without a key.
Status previewControllers(app::Session& session, const ControllerTool& tool);

/// Puts back what was shown without a key where the change is not kept. Comes before the session's drag is
/// ended.
void endControllers(app::Session& session, const ControllerTool& tool, bool keep);

} // namespace stretch::ui

#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/commands/keys/keys_modal.h"
#include "app/commands/trail/exaggerate.h"
#include "app/commands/trail/spheres.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/session.h"
#include "ui/panels/state/ui_state.h"
#include "ui/render/view/camera.h"
#include "ui/viewport/controller_tool.h"

namespace stretch::ui {

/// E: exaggerating trails, until Enter or Esc.
struct ExaggerateTool {
  app::ExaggerateTargets targets;
  app::ExaggerateModal modal;
  std::string limbTitle; ///< "left arm", "2 limbs".
};

/// Pulling spheres, or a tangent's handle.
struct GrabTool : Pull {
  int trailId = 0;
  app::Document base;                        ///< Document that the pull starts from.
  rig::TrailSettings settings;               ///< Settings of the trail at the beginning.
  std::vector<app::PlacedSphere> spheres;    ///< Places where they stood.
  std::vector<double> selected;              ///< Frames of those that are pulled in full.
  double falloffRadius = 0.0;                ///< World units; 0: only the selected.
  std::optional<app::TangentHandle> tangent; ///< This handle is pulled, and no sphere.
  Vec3 slope{0.0}; ///< Slope of the sphere's offset at the beginning, along the trail's axes.
};

/// Moving or scaling picked keys of graph and dope sheet, by G or S until Enter or a click.
struct KeysTool {
  app::KeysModal modal;
  app::KeySelection picked; ///< When it began.
  std::optional<Vec2> from; ///< The mouse at the beginning: frame and value.
};

/// Tool that takes all keys until it ends; none most of the time.
using Tool = std::variant<std::monostate, ExaggerateTool, GrabTool, ControllerTool, KeysTool>;

[[nodiscard]] inline bool isRunning(const Tool& tool) {
  return !std::holds_alternative<std::monostate>(tool);
}

/// Begins E: trails are made where there are none, and everything previews.
Status startExaggerate(app::Session& session, Tool& tool,
                       app::OverlapChoice choice = app::OverlapChoice::edit);

/// Begins pulling the selected spheres. `startPixels` and `anchor` say what the mouse holds.
struct GrabStart {
  Vec2 startPixels{0.0};
  std::optional<double> heldFrame; ///< The sphere under the mouse; else the last selected one.
  std::optional<int> axis;         ///< Locked from the beginning: an axis handle was taken.
  bool byDrag = false;
  double falloffRadius = 0.0;
};
Status startGrab(app::Session& session, Tool& tool, const GrabStart& start);

/// Begins pulling a tangent handle, which is shown at `tipWorld`.
Status startTangentGrab(app::Session& session, Tool& tool, const app::TangentHandle& handle,
                        const Vec3& tipWorld, const GrabStart& start);

/// Begins pulling a limb by its end: the sphere of its trail at the playhead, both made where they are not
/// there.
Status startLimbGrab(app::Session& session, Tool& tool, const std::string& limbId, const GrabStart& start);

/// Begins moving or scaling the picked keys; `modal` says how they are shown.
Status startKeys(app::Session& session, Tool& tool, const app::KeysModal& modal);
/// The mouse over the pane of a running KeysTool, as frame and value; nothing for other tools.
Status moveKeysMouse(app::Session& session, Tool& tool, const Vec2& at);
/// Begins moving or turning the selected controllers.
Status startControllerTool(app::Session& session, Tool& tool, const ControllerStart& start);

/// A key for the running tool. An error tells why the preview could not follow.
Status pressToolKey(app::Session& session, Tool& tool, const app::KeyPress& press);
/// The mouse for what it pulls or turns; nothing for other tools.
Status moveToolMouse(app::Session& session, Tool& tool, const View& view, const Vec2& mousePixels);
/// Widens (factor above 1) or narrows the soft falloff.
Status turnFalloff(app::Session& session, Tool& tool, double steps);

/// Another stroke for the trails that E made, the next one in time or the one before: the working range goes
/// along. False where there is none.
bool goToStroke(app::Session& session, ExaggerateTool& tool, bool forwards);

/// The frame of the tip of the trail that E works on; nothing outside of E.
[[nodiscard]] std::optional<double> tipFrame(const app::Session& session, const Tool& tool);

/// Ends the tool: kept as one undo step, or restored.
void finishTool(app::Session& session, Tool& tool, bool keep);

/// Describes the tool: text for the status bar and what the keys do.
void describeTool(const Tool& tool, EditorStatus& status);

} // namespace stretch::ui

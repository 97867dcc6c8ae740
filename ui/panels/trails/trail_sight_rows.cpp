#include <functional>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/evaluate/seen.h"
#include "app/schema/trail_schema.h"
#include "rig/motion/trail_camera.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

using rig::Sight;
using rig::TrailSettings;

/// A camera as the list offers it.
struct CameraChoice {
  Choice choice;
  std::function<void(Sight&)> take;
  bool isTaken = false;
};

CameraChoice named(const Sight& sight, const std::string& name, const std::string& help) {
  return {{capitalised(name), {capitalised(name), help, {}}},
          [name](Sight& s) {
            s.camera = name;
            s.view.reset();
          },
          sight.camera == name};
}

std::vector<CameraChoice> camerasFor(const PanelContext& context, const Sight& sight) {
  const CameraPlace now = context.character().view().camera;
  const bool isKept = sight.camera.empty() && sight.view.has_value();
  std::vector<CameraChoice> cameras{
      {{"None", {"No camera", "The scale counts in the limb's own length.", {}}},
       [](Sight& s) {
         Sight none;
         none.keepDepth = s.keepDepth;
         s = none;
       },
       !sight.hasCamera()},
      {{isKept ? "Kept view" : "This view",
        {"This view", "Keeps what the viewport shows now with the trail, as its camera.", {}}},
       [now](Sight& s) {
         s.camera.clear();
         s.view = now;
       },
       isKept}};
  for (const SceneCamera& camera : context.character().document().scene->cameras) {
    cameras.push_back(named(sight, camera.name, "A camera of the file, where it stands at the tip."));
    cameras.back().choice.text = camera.name;
  }
  for (const std::string_view view : rig::standardViews) {
    cameras.push_back(named(sight, std::string(view), "Seen from there without perspective."));
  }
  return cameras;
}

void cameraRow(PanelContext& context, const rig::Trail& trail) {
  const Help help = settingHelp(*app::findSetting(app::trailSchema(), "camera"));
  labelledRow(widgetsOf(context), "Camera", help);
  const std::vector<CameraChoice> cameras = camerasFor(context, trail.settings.sight);
  std::vector<Choice> choices;
  int selected = -1;
  for (const CameraChoice& camera : cameras) {
    selected = camera.isTaken ? static_cast<int>(choices.size()) : selected;
    choices.push_back(camera.choice);
  }
  const int chosen = dropdown(widgetsOf(context), "trail/camera", choices, selected, help, 0.0F,
                              trail.settings.sight.camera.c_str());
  if (chosen >= 0) {
    editSettings(context, {true, true}, "Change the camera", [&](TrailSettings& settings) {
      cameras[static_cast<std::size_t>(chosen)].take(settings.sight);
    });
  }
}

/// Looked for anew where the motion or the camera is another.
const SeenState& seenNow(PanelContext& context, const rig::SolvedTrail& solved, const CameraPlace& camera) {
  app::Session& session = context.character();
  SeenState& seen = context.ui.trails.seen;
  const std::shared_ptr<const rig::MotionState> motion = session.sharedMotion();
  if (seen.motion != motion || seen.trailId != solved.trail.id || !(seen.camera == camera)) {
    const auto found = app::seenBy(session.document(), *motion, solved, camera);
    seen = {motion, solved.trail.id, camera,
            found ? fmt::format("\xC3\x97{:.2f} of \xC3\x97{:.2f}  ({:.0f} %)", found->ratio, found->of,
                                100.0 * found->share)
                  : "behind the camera"};
  }
  return seen;
}

void seenRow(PanelContext& context, const rig::Trail& trail) {
  const rig::SolvedTrail* const solved = app::solvedTrail(context.character(), trail.id);
  if (solved == nullptr || !solved->active) {
    return;
  }
  const bool isJudged = solved->camera.has_value();
  const SeenState& seen =
      seenNow(context, *solved, isJudged ? *solved->camera : context.character().view().camera);
  valueRow(
      widgetsOf(context), isJudged ? "Seen" : "Seen here", seen.text,
      {.title = "How much of the exaggeration is seen",
       .text = "The limb's length at the tip in the picture, over that in the source, of what was asked for; "
               "and the share of the exaggeration that does not point along the view."});
}

} // namespace

void sightRows(PanelContext& context, const rig::Trail& trail) {
  cameraRow(context, trail);
  const CameraPlace now = context.character().view().camera;
  trailSection(context, trail, "sight",
               [now](TrailSettings& s) {
                 if ((s.sight.asSeen || s.sight.turnDegrees > 0.0) && !s.sight.hasCamera()) {
                   s.sight.view = now;
                 }
               },
               {"camera"});
  seenRow(context, trail);
  commandButton(
      context,
      {.command = command::viewBest, .text = "Best view", .width = ImGui::GetContentRegionAvail().x});
}

} // namespace stretch::ui

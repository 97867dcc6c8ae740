#include <algorithm>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "core/anim/frames.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

using rig::TrailSettings;

/// Frames of the release as it is solved, default included.
double releaseFrames(const rig::SolvedTrail* solved, double framesPerSecond) {
  return solved == nullptr ? 0.0 : solved->release.seconds() * framesPerSecond;
}

void sphereOffsetRow(PanelContext& context, const rig::Trail& trail, double frame) {
  const WidgetContext widgets = widgetsOf(context);
  const auto found = std::ranges::find_if(
      trail.settings.spheres, [&](const rig::SphereOffset& s) { return sameFrame(s.frame, frame); });
  rig::SphereOffset sphere =
      found != trail.settings.spheres.end() ? *found : rig::SphereOffset{frame, Vec3(0.0)};
  const double reach = context.character().document().body.height * 2.0;
  labelledRow(widgets, "Offset",
              {"Offset of the sphere at frame " + shortNumber(frame),
               "How far the path is pulled there, along the axes of the trail's space.",
               {}});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                      ImVec2(context.theme.px(4.0F), ImGui::GetStyle().ItemSpacing.y));
  const float width = columnWidth(3);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    if (axis > 0) {
      ImGui::SameLine();
    }
    const char* const names[] = {"X", "Y", "Z"};
    SliderSpec spec{.id = std::string("trail/sphere-") + names[axis],
                    .minimum = -reach,
                    .maximum = reach,
                    .step = 0.001,
                    .showsFill = false,
                    .width = width};
    spec.defaultValue = 0.0;
    spec.help = {
        std::string("Offset along ") + names[axis], "Drag, click to type, right click for a menu.", {}};
    const EditPhase phase = slider(widgets, spec, sphere.offset[axis]);
    editThrough(context, phase, "Move the sphere",
                [&](const app::Document& start) { return app::setSphereOffset(start, trail.id, sphere); });
  }
  ImGui::PopStyleVar();
}

void tangentRow(PanelContext& context) {
  labelledRow(
      widgetsOf(context), "Tangent",
      {"Tangent",
       "The squares beside the sphere in the viewport: drag one and the path bends through the sphere. "
       "Off here means that it runs as its neighbours say.",
       {}});
  commandButton(context, {.command = command::sphereSmooth,
                          .icon = icon::undo,
                          .text = "Reset",
                          .width = ImGui::GetContentRegionAvail().x});
}

} // namespace

namespace {

/// Of the clip, not of the trail; it stands where its effect is looked for.
void loopRow(PanelContext& context, int clip) {
  const app::Document& document = context.character().document();
  const bool loops = app::isLooping(document, clip);
  const CommandInfo* const info = findCommand(context, command::clipLoop);
  const Help help{"Clip loops", info == nullptr ? "" : info->help, keyOf(context, command::clipLoop)};
  labelledRow(widgetsOf(context), "Clip loops", help);
  if (toggle(widgetsOf(context), "trail/clip-loops", loops ? "On" : "Off", loops, help)) {
    request(context, command::clipLoop);
  }
}

} // namespace

void releaseRows(PanelContext& context, const rig::Trail& trail) {
  const double rate = app::clipOf(context.character().document(), trail.clip).framesPerSecond;
  const double last = std::max(1.0, app::lastFrame(context.character().document(), trail.clip));
  const double solved = releaseFrames(app::solvedTrail(context.character(), trail.id), rate);
  trailRow(context, trail, "release", {}, {.automatic = solved, .maximum = last});
  trailSection(context, trail, "release", {}, {"release"});
  loopRow(context, trail.clip);
}

void sphereRows(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  app::Session& session = context.character();
  const rig::SolvedTrail* solved = app::solvedTrail(session, trail.id);
  const std::size_t count = solved != nullptr ? solved->controlFrames.size() : 0;
  labelledRow(widgets, "Spheres",
              {"Control spheres", "Points of the path that can be pulled, at the keys of the limb.", {}});
  const float width = columnWidth(2);
  commandButton(context,
                {.command = command::spherePrevious, .icon = icon::stepBack, .text = "Back", .width = width});
  ImGui::SameLine();
  commandButton(context,
                {.command = command::sphereNext, .icon = icon::stepForward, .text = "Next", .width = width});
  labelledRow(widgets, "");
  commandButton(context, {.command = command::sphereAdd, .icon = icon::plus, .text = "Add", .width = width});
  ImGui::SameLine();
  commandButton(context,
                {.command = command::sphereReset, .icon = icon::undo, .text = "Reset", .width = width});
  const std::vector<double>& selected = session.view().selection.spheres();
  const std::string state = selected.empty() ? std::to_string(trail.settings.spheres.size()) + " pulled"
                                             : std::to_string(selected.size()) + " selected";
  valueRow(widgets, "", std::to_string(count) + " spheres, " + state);
  if (selected.size() == 1) {
    sphereOffsetRow(context, trail, selected.front());
    tangentRow(context);
  }
  labelledRow(
      widgets, "Follow",
      {"Follow", "The character follows while a sphere is dragged.", keyOf(context, command::trailFollow)});
  if (toggle(widgets, "trail/follow", trail.follow ? "On" : "Off", trail.follow,
             {"Follow", "The character follows while a sphere is dragged.",
              keyOf(context, command::trailFollow)})) {
    editOnce(context, "Follow", app::setFollow(session.document(), trail.id, !trail.follow));
  }
}

} // namespace stretch::ui

#include <algorithm>
#include <cmath>

#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "app/edits/sphere_edits.h"
#include "app/edits/trail_edits.h"
#include "ui/panels/command_ids.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/panels/setting_rows.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/remap_editor.h"

namespace stretch::ui {

namespace {

using rig::TrailSettings;

void rangeRow(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, "Range", {"Range", "First and last frame of the trail.", {}});
  const double last = app::lastFrame(context.session->document(), trail.clip);
  const float width = columnWidth(2);
  SliderSpec spec{.id = "trail/range-start",
                  .minimum = 0.0,
                  .maximum = last,
                  .step = 1.0,
                  .decimals = 0,
                  .showsFill = false,
                  .width = width};
  spec.help = {"First frame", "Drag, or double click to type.", keyOf(context, command::rangeStart)};
  double start = trail.settings.startFrame;
  EditPhase phase = slider(widgets, spec, start);
  editSettings(context, phase, "Change the range",
               [&](TrailSettings& s) { s.startFrame = std::min(start, s.endFrame - 1.0); });
  ImGui::SameLine();
  spec.id = "trail/range-end";
  spec.help = {"Last frame", "Drag, or double click to type.", keyOf(context, command::rangeEnd)};
  double end = trail.settings.endFrame;
  phase = slider(widgets, spec, end);
  editSettings(context, phase, "Change the range",
               [&](TrailSettings& s) { s.endFrame = std::max(end, s.startFrame + 1.0); });
}

void scaleRows(PanelContext& context, const rig::Trail& trail) {
  numberRow(context,
            {.setting = "scale",
             .label = "Scale",
             .undoLabel = "Change the scale",
             .minimum = 0.0,
             .maximum = rig::largestScale,
             .defaultValue = 1.0,
             .hardMaximum = 100.0,
             .prefix = "\xC3\x97"},
            trail.settings, &TrailSettings::scale);
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, "Axes", settingHelp("axes", "Axes"));
  const Help help{.text = "Click turns this axis on or off, Shift+click leaves only this one on."};
  if (const int axis = axisButtons(widgets, "trail/axes", trail.settings.axes, help); axis >= 0) {
    const auto chosen = static_cast<std::size_t>(axis);
    const bool only = ImGui::GetIO().KeyShift;
    editSettings(context, {true, true}, "Change the axes", [&](TrailSettings& s) {
      if (only) {
        s.axes = {false, false, false};
      }
      s.axes[chosen] = only || !trail.settings.axes[chosen];
    });
  }
  choiceRow(
      context,
      {.setting = "pivot", .label = "Pivot", .undoLabel = "Change the pivot", .choices = {"Start", "End"}},
      trail.settings, &TrailSettings::pivot);
}

void proposeRangeEnd(PanelContext& context, const rig::SolvedTrail& solved) {
  const auto sample = static_cast<std::size_t>(std::max(0, solved.tip.farthestSample));
  if (sample >= solved.path.samples.size()) {
    return;
  }
  const double rate = app::clipOf(context.session->document(), solved.trail.clip).framesPerSecond;
  const double frame = std::round(solved.path.samples[sample].timeSeconds * rate);
  ButtonSpec propose;
  propose.id = "trail/use-farthest";
  propose.text = "End the range at frame " + shortNumber(frame, 0);
  propose.help = {propose.text, "There the limb is farthest from the pivot.", {}};
  propose.width = ImGui::GetContentRegionAvail().x;
  if (button(widgetsOf(context), propose)) {
    const bool tipIsEnd = solved.settings.pivot == rig::Pivot::start;
    editSettings(context, {true, true}, "Change the range",
                 [&](TrailSettings& s) { (tipIsEnd ? s.endFrame : s.startFrame) = frame; });
  }
}

std::string tipProblem(const rig::SolvedTrail& solved) {
  if (solved.tip.outcome == rig::TipOutcome::nothingToScale) {
    return "Nothing to scale: the path does not move along the active axes. Turn on an axis, or choose "
           "another range.";
  }
  if (solved.tip.moved) {
    return "The path comes back on itself, so it is moved instead of scaled.";
  }
  if (solved.tip.outcome == rig::TipOutcome::pulled) {
    return "The path's line does not reach that length: the tip is pulled the rest of the way.";
  }
  return {};
}

/// What became of the tip: its length, and why it is not what was asked for.
void tipMessages(PanelContext& context, int trailId) {
  const WidgetContext widgets = widgetsOf(context);
  const rig::SolvedTrail* solved = app::solvedTrail(*context.session, trailId);
  if (solved == nullptr) {
    return;
  }
  const TipLengths lengths = tipLengths(*context.session, *solved);
  valueRow(widgets, "Tip length", lengthsText(lengths),
           {.title = "Length of the limb at the tip",
            .text = "Straight from its base to its end: in the source clip, and as it is now."});
  if (!solved->trail.exaggerated) {
    return;
  }
  if (const std::string problem = tipProblem(*solved); !problem.empty()) {
    notice(widgets, NoticeKind::info, problem);
  }
  for (const std::string& warning : solved->warnings) {
    notice(widgets, NoticeKind::warning, warning);
  }
  if (solved->tip.moved) {
    proposeRangeEnd(context, *solved);
  }
}

void remapRows(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  const TrailSettings& settings = trail.settings;
  const rig::Remap curve(settings.remap, settings.easeIn, settings.easeOut);
  RemapPoints points{{settings.easeIn.percent, settings.easeIn.value},
                     {settings.easeOut.percent, settings.easeOut.value}};
  const auto set = [](const RemapPoints& p, TrailSettings& s) {
    s.easeIn = {p.easeIn.x, p.easeIn.y};
    s.easeOut = {p.easeOut.x, p.easeOut.y};
  };
  const float height = std::min(ImGui::GetContentRegionAvail().x * 0.72F, context.theme.px(180.0F));
  const EditPhase phase = remapEditor(
      widgets, "trail/remap-curve", [&](double r) { return curve.at(r); }, points, trailColour(trail.colour),
      height);
  editSettings(context, phase, "Shape the transition", [&](TrailSettings& s) { set(points, s); });
  easeRow(context, {"ease_in", "Ease-in", "trail/ease-in"}, points.easeIn, {0.0, 0.5},
          [&](const Vec2& value, TrailSettings& s) {
            set(clampedRemap({value, points.easeOut}), s);
          });
  easeRow(context, {"ease_out", "Ease-out", "trail/ease-out"}, points.easeOut, {0.5, 1.0},
          [&](const Vec2& value, TrailSettings& s) {
            set(clampedRemap({points.easeIn, value}), s);
          });
  choiceRow(context,
            {.setting = "remap",
             .label = "Curve",
             .undoLabel = "Change the curve",
             .choices = {"Spline", "Linear"}},
            settings, &TrailSettings::remap);
}

void spaceRows(PanelContext& context, const rig::Trail& trail) {
  const TrailSettings& settings = trail.settings;
  const Mat3 camera = context.ui.cameraAxes;
  choiceRow(context,
            {.setting = "space",
             .label = "Space",
             .undoLabel = "Change the space",
             .choices = {"World", "Root", "Base", "View"},
             .also =
                 [camera](TrailSettings& s) {
                   if (s.space == rig::TrailSpace::view) {
                     s.viewAxes = camera;
                   }
                 }},
            settings, &TrailSettings::space);
  choiceRow(context,
            {.setting = "reference",
             .label = "Reference",
             .undoLabel = "Change the reference",
             .choices = {"Pose", "Rest"}},
            settings, &TrailSettings::reference);
  flagRow(context, {.setting = "pull", .label = "Pull", .undoLabel = "Change the pull"}, settings,
          &TrailSettings::pull);
  flagRow(context, {.setting = "stay_in_world", .label = "Stay in world", .undoLabel = "Stay in world"},
          settings, &TrailSettings::stayInWorld);
}

void limbRows(PanelContext& context, const rig::Trail& trail) {
  const TrailSettings& settings = trail.settings;
  choiceRow(
      context,
      {.setting = "bend", .label = "Bend", .undoLabel = "Change the bend", .choices = {"Keep", "Straighten"}},
      settings, &TrailSettings::bend);
  numberRow(context,
            {.setting = "blend", .label = "Blend", .undoLabel = "Blend", .maximum = 2.0, .defaultValue = 2.0},
            settings, &TrailSettings::blend);
  numberRow(context,
            {.setting = "switch",
             .label = "Stretch",
             .undoLabel = "Change the stretch",
             .defaultValue = 1.0,
             .suffix = " %",
             .decimals = 0,
             .factor = 100.0},
            settings, &TrailSettings::stretchSwitch);
  numberRow(context,
            {.setting = "volume",
             .label = "Volume",
             .undoLabel = "Change the volume",
             .defaultValue = 1.0,
             .suffix = " %",
             .decimals = 0,
             .factor = 100.0},
            settings, &TrailSettings::volume);
  flagRow(context, {.setting = "turn_end", .label = "Turn end", .undoLabel = "Turn the end"}, settings,
          &TrailSettings::turnEnd);
}

/// Frames of the release as it is solved, default included.
double releaseFrames(const rig::SolvedTrail* solved, double framesPerSecond) {
  return solved == nullptr ? 0.0 : solved->release.seconds() * framesPerSecond;
}

void releaseRows(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  const TrailSettings& settings = trail.settings;
  const double rate = app::clipOf(context.session->document(), trail.clip).framesPerSecond;
  const double last = std::max(1.0, app::lastFrame(context.session->document(), trail.clip));
  labelledRow(widgets, "Release", settingHelp("release", "Release"));
  const bool automatic = !settings.releaseFrames.has_value();
  double frames =
      settings.releaseFrames.value_or(releaseFrames(app::solvedTrail(*context.session, trail.id), rate));
  const float autoWidth = context.theme.px(52.0F);
  SliderSpec spec{.id = "trail/release", .maximum = last, .step = 1.0, .decimals = 0, .suffix = " frames"};
  spec.width = ImGui::GetContentRegionAvail().x - autoWidth - ImGui::GetStyle().ItemSpacing.x;
  spec.help = settingHelp("release", "Release");
  const EditPhase phase = slider(widgets, spec, frames);
  editSettings(context, phase, "Change the release", [&](TrailSettings& s) { s.releaseFrames = frames; });
  ImGui::SameLine();
  ButtonSpec reset{.id = "trail/release-auto", .text = "Auto", .on = automatic, .width = autoWidth};
  reset.help = {
      "Automatic release", "To the limb's next key on a sparsely keyed clip, else a third of the range.", {}};
  if (button(widgets, reset)) {
    const std::optional<double> next = automatic ? std::optional<double>(std::round(frames)) : std::nullopt;
    editSettings(context, {true, true}, "Change the release",
                 [&](TrailSettings& s) { s.releaseFrames = next; });
  }
  numberRow(context,
            {.setting = "overshoot",
             .label = "Overshoot",
             .undoLabel = "Change the overshoot",
             .defaultValue = 0.0,
             .suffix = " %",
             .decimals = 0,
             .factor = 100.0},
            settings, &TrailSettings::overshoot);
}

void sphereOffsetRow(PanelContext& context, const rig::Trail& trail, double frame) {
  const WidgetContext widgets = widgetsOf(context);
  const auto found = std::find_if(trail.settings.spheres.begin(), trail.settings.spheres.end(),
                                  [&](const rig::SphereOffset& s) { return app::sameFrame(s.frame, frame); });
  rig::SphereOffset sphere =
      found != trail.settings.spheres.end() ? *found : rig::SphereOffset{frame, Vec3(0.0)};
  const double reach = context.session->document().biped.height * 2.0;
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
        std::string("Offset along ") + names[axis], "Drag, double click to type, right click for 0.", {}};
    const EditPhase phase = slider(widgets, spec, sphere.offset[axis]);
    editThrough(context, phase, "Move the sphere",
                [&](const app::Document& start) { return app::setSphereOffset(start, trail.id, sphere); });
  }
  ImGui::PopStyleVar();
}

void sphereRows(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  app::Session& session = *context.session;
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
  const std::vector<double>& selected = session.view().selectedSpheres;
  const std::string state = selected.empty() ? std::to_string(trail.settings.spheres.size()) + " pulled"
                                             : std::to_string(selected.size()) + " selected";
  valueRow(widgets, "", std::to_string(count) + " spheres, " + state);
  if (selected.size() == 1) {
    sphereOffsetRow(context, trail, selected.front());
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

void settingSections(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  std::vector<std::string>& closed = context.ui.closedSections;
  rangeRow(context, trail);
  scaleRows(context, trail);
  tipMessages(context, trail.id);
  if (section(widgets, "trail/section-transition", "Transition", closed)) {
    remapRows(context, trail);
  }
  if (section(widgets, "trail/section-limb", "Limb", closed)) {
    limbRows(context, trail);
  }
  if (section(widgets, "trail/section-release", "Back to the original motion", closed)) {
    releaseRows(context, trail);
  }
  if (section(widgets, "trail/section-spheres", "Control spheres", closed)) {
    sphereRows(context, trail);
  }
  if (section(widgets, "trail/section-space", "Space", closed)) {
    spaceRows(context, trail);
    stopRows(context, trail);
  }
}

} // namespace

void drawTrailSettingsPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  if (!hasViewedClip(context)) {
    return;
  }
  verticalSpace(widgets, 8.0F);
  separator(widgets);
  app::Session& session = *context.session;
  const rig::Trail* selected = app::selectedTrail(session);
  if (selected == nullptr) {
    panelTitle(widgets, icon::sliders, "Settings");
    note(widgets, "Select a trail to see its range, scale, axes and transition.");
    return;
  }
  const rig::Trail trail = *selected; // a copy: rows edit the document while the others are drawn
  const std::size_t also = app::targetTrails(session).size() - 1;
  panelTitle(widgets, icon::sliders,
             limbHeading(session.document(), trail.limb) +
                 (also > 0 ? " and " + std::to_string(also) + " more" : ""));
  settingSections(context, trail);
  verticalSpace(widgets, 8.0F);
  separator(widgets);
  commandButton(context, {.command = command::trailDelete,
                          .icon = icon::trash,
                          .text = "Delete the trail",
                          .emphasis = Emphasis::danger,
                          .width = ImGui::GetContentRegionAvail().x});
}

} // namespace stretch::ui

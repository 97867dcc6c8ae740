#include <algorithm>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/remap_editor.h"

namespace stretch::ui {

namespace {

using rig::TrailSettings;

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
      widgets, "trail/remap-curve", [&](double r) { return curve.at(r); }, points,
      trailColour(trail.colour, context.theme.kind), height);
  editSettings(context, phase, "Shape the transition", [&](TrailSettings& s) { set(points, s); });
  trailSection(context, trail, "transition", [&](TrailSettings& s) {
    set(clampedRemap({{s.easeIn.percent, s.easeIn.value}, {s.easeOut.percent, s.easeOut.value}}), s);
  });
}

void spaceRows(PanelContext& context, const rig::Trail& trail) {
  const Mat3 camera = context.character().view().cameraAxes;
  trailRow(context, trail, "space", [camera](TrailSettings& s) {
    if (s.space == rig::TrailSpace::view) {
      s.viewAxes = camera;
    }
  });
  trailSection(context, trail, "space", {}, {"space"});
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
    trailSection(context, trail, "limb");
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
  if (section(widgets, "trail/section-sight", "Camera", closed)) {
    sightRows(context, trail);
  }
  weightSection(context, trail.limb);
  holdSection(context);
}

/// What to do for a limb of which no trail is selected: where those are that it has, or how to make one.
std::string noTrailNote(const PanelContext& context, const std::string& limbId) {
  const app::Session& session = context.character();
  std::string frames;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.limb == limbId && trail.clip == session.view().clip) {
      frames += fmt::format("{}{:.4g} to {:.4g}", frames.empty() ? "" : ", ", trail.settings.startFrame,
                            trail.settings.endFrame);
    }
  }
  return frames.empty()
             ? "Make a trail to see its range, scale, axes and transition."
             : fmt::format(
                   "Its trails lie at frames {}: click one, or press {} to go there, {} for the stroke "
                   "here.",
                   frames, keyOf(context, command::sphereNext), keyOf(context, command::trailExaggerate));
}

// Without a trail there is still the weight of the selected limb.
void drawLimbSettings(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const std::vector<std::string> limbs = app::targetLimbs(context.character());
  if (limbs.empty()) {
    panelTitle(widgets, icon::sliders, "Settings");
    note(widgets, "Select a limb, a trail or a controller to see its settings.");
    return;
  }
  const std::size_t also = limbs.size() - 1;
  panelTitle(widgets, icon::sliders,
             limbHeading(context.character().document(), limbs.front()) +
                 (also > 0 ? " and " + std::to_string(also) + " more" : ""));
  note(widgets, noTrailNote(context, limbs.front()));
  weightSection(context, limbs.front());
}

} // namespace

void drawTrailSettingsPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  if (!hasViewedClip(context)) {
    return;
  }
  verticalSpace(widgets, 8.0F);
  separator(widgets);
  app::Session& session = context.character();
  const rig::Trail* selected = app::selectedTrail(session);
  if (selected == nullptr) {
    drawLimbSettings(context);
    holdSection(context);
    return;
  }
  const rig::Trail trail = *selected; // a copy: rows edit the document while the others are drawn
  const std::size_t also = app::targetTrails(session).size() - 1;
  panelTitle(widgets, icon::sliders,
             trailHeading(session.document(), trail) +
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
#include "app/commands/command_ids.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

struct OverlayNumber {
  const char* id;
  const char* label;
  const char* help;
  double minimum;
  double maximum;
  double step;
  const char* suffix;
};

template <typename Number>
void numberRow(PanelContext& context, const OverlayNumber& row, Number& value) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help{row.label, row.help, {}};
  labelledRow(widgets, row.label, help);
  SliderSpec spec{.id = std::string("overlay/") + row.id,
                  .minimum = row.minimum,
                  .maximum = row.maximum,
                  .step = row.step,
                  .decimals = row.step < 1.0 ? 1 : 0,
                  .suffix = row.suffix,
                  .help = help};
  auto number = static_cast<double>(value);
  if (slider(widgets, spec, number).changed) {
    value = static_cast<Number>(number);
  }
}

void flagRow(PanelContext& context, const char* id, const char* label, const char* help, bool& value) {
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, label, {label, help, {}});
  if (toggle(widgets, std::string("overlay/") + id, value ? "On" : "Off", value, {label, help, {}})) {
    value = !value;
  }
}

void displayPopup(PanelContext& context) {
  ViewportOverlays& overlays = context.ui.overlays;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.theme.px(12.0F), context.theme.px(12.0F)));
  ImGui::SetNextWindowSize({context.theme.px(320.0F), 0.0F});
  if (ImGui::BeginPopup("overlay/popup")) {
    panelTitle(widgetsOf(context), icon::sliders, "Trails and ghosts");
    numberRow(context,
              {"thickness", "Thickness", "Of the exaggerated trail, in pixels.", 1.0, 8.0, 0.5, " px"},
              overlays.trailThickness);
    numberRow(context,
              {"sphere-size", "Spheres", "Size of the control spheres, in pixels.", 3.0, 16.0, 0.5, " px"},
              overlays.sphereSize);
    numberRow(
        context,
        {"increment", "Sampling", "Frames between two points of a drawn trail.", 0.1, 4.0, 0.1, " frames"},
        overlays.trailIncrement);
    flagRow(context, "ticks", "Frame ticks", "Their spacing shows the speed.", overlays.trailTicks);
    flagRow(context, "only-selected", "Selected only",
            "Draws the trails of the selected limbs and the pinned ones.", overlays.trailsOnlyWhenSelected);
    flagRow(context, "window", "Near frames", "Draws trails only around the playhead.", overlays.trailWindow);
    numberRow(context,
              {"window-frames", "Window", "Frames before and after the playhead.", 1.0, 60.0, 1.0, " frames"},
              overlays.trailWindowFrames);
    numberRow(context,
              {"ghosts-before", "Ghosts before", "Number of ghosts before the playhead.", 0.0, 10.0, 1.0, ""},
              overlays.ghostsBefore);
    numberRow(context,
              {"ghosts-after", "Ghosts after", "Number of ghosts after the playhead.", 0.0, 10.0, 1.0, ""},
              overlays.ghostsAfter);
    numberRow(context, {"ghost-step", "Ghost step", "Frames between two ghosts.", 1.0, 20.0, 1.0, " frames"},
              overlays.ghostStepFrames);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

} // namespace

void drawViewportBar(PanelContext& context) {
  iconButton(context, command::viewSkeleton, icon::skeleton, "Sk");
  iconButton(context, command::viewWire, icon::wire, "Wi");
  iconButton(context, command::viewJointNames, icon::tag, "Na");
  iconButton(context, command::viewHeatMap, icon::fire, "He");
  iconButton(context, command::viewGhosts, icon::ghosts, "Gh");
  iconButton(context, command::viewFrameNumbers, icon::numbers, "12");
  iconButton(context, command::viewGrid, icon::grid, "Gr");
  iconButton(context, command::viewSideBySide, icon::columns, "||");
  ButtonSpec more{.id = "overlay/more",
                  .icon = icon::sliders,
                  .emphasis = Emphasis::quiet,
                  .width = context.theme.px(30.0F),
                  .fallback = "..."};
  more.help = {"Trails and ghosts", "How trails, spheres and ghosts are drawn.", {}};
  if (button(widgetsOf(context), more)) {
    ImGui::OpenPopup("overlay/popup");
  }
  displayPopup(context);
}

} // namespace stretch::ui

#include "app/commands/command_ids.h"
#include "core/gltf/json.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/panels/setting_rows.h"
#include "ui/panels/view_schema.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void displayPopup(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.theme.px(12.0F), context.theme.px(12.0F)));
  ImGui::SetNextWindowSize({context.theme.px(320.0F), 0.0F});
  if (ImGui::BeginPopup("overlay/popup")) {
    panelTitle(widgetsOf(context), icon::sliders, "Trails and ghosts");
    for (const app::Setting<ViewportOverlays>& setting : overlaySchema()) {
      if (setting.row.section == "trails") {
        viewRow(context, "overlay/", setting, context.ui.overlays);
      }
    }
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

#include <array>

#include "app/commands/table/command_ids.h"
#include "core/gltf/json/json.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/context/row_parts.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/context/view_schema.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void displayPopup(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.theme.px(12.0F), context.theme.px(12.0F)));
  ImGui::SetNextWindowSize({context.theme.px(320.0F), 0.0F});
  if (ImGui::BeginPopup("overlay/popup")) {
    if (keyPressed(ImGuiKey_Escape)) {
      ImGui::CloseCurrentPopup();
    }
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
  constexpr std::array<std::array<const char*, 3>, 10> switches{
      {{command::viewControllers, icon::controllers, "Co"},
       {command::viewSkeleton, icon::skeleton, "Sk"},
       {command::viewWire, icon::wire, "Wi"},
       {command::viewJointNames, icon::tag, "Na"},
       {command::viewWeights, icon::brush, "We"},
       {command::viewHeatMap, icon::fire, "He"},
       {command::viewGhosts, icon::ghosts, "Gh"},
       {command::viewFrameNumbers, icon::numbers, "12"},
       {command::viewGrid, icon::grid, "Gr"},
       {command::viewSideBySide, icon::columns, "||"}}};
  const float side = context.theme.px(30.0F);
  std::vector<RowControl> parts;
  parts.reserve(switches.size());
  for (const auto& entry : switches) {
    parts.push_back({side + context.theme.px(2.0F),
                     [&context, &entry] { iconButton(context, entry[0], entry[1], entry[2]); }});
  }
  rowOfParts(context, "overlay/hidden", ImGui::GetContentRegionAvail().x - side, parts);
  ButtonSpec more{.id = "overlay/more",
                  .icon = icon::sliders,
                  .emphasis = Emphasis::quiet,
                  .width = side,
                  .fallback = "..."};
  more.help = {"Trails and ghosts", "How trails, spheres and ghosts are drawn.", {}};
  if (button(widgetsOf(context), more)) {
    ImGui::OpenPopup("overlay/popup");
  }
  displayPopup(context);
}

} // namespace stretch::ui

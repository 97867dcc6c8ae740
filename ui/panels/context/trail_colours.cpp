#include "ui/panels/context/trail_colours.h"

#include "app/edits/trail/trail_edits.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

bool trailColours(PanelContext& context, const rig::Trail& trail, const std::string& prefix) {
  const WidgetContext widgets = widgetsOf(context);
  bool chosen = false;
  for (int i = 0; i < static_cast<int>(trailPalette.size()); ++i) {
    if (i > 0) {
      ImGui::SameLine(0.0F, context.theme.px(4.0F));
    }
    const float side = context.theme.rowHeight();
    const Control swatch = takePlace(widgets, prefix + std::to_string(i), {side, side});
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddCircleFilled(swatch.box.centre(), context.theme.px(swatch.hovered ? 10.0F : 8.0F),
                          trailColour(i, context.theme.kind));
    if (i == trail.colour) {
      list->AddCircle(swatch.box.centre(), context.theme.px(11.0F), context.theme.colours.text, 0,
                      context.theme.px(1.5F));
    }
    tooltip(widgets,
            {.title = "Colour " + std::to_string(i + 1), .text = "Of the trail, its bar and its limb."});
    if (swatch.clicked) {
      editOnce(
          context, "Change the trail's colour",
          app::setTrailDisplay(context.character().document(), trail.id, {i, trail.visible, trail.pinned}));
      chosen = true;
    }
  }
  return chosen;
}

} // namespace stretch::ui

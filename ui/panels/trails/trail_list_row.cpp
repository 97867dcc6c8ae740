#include "ui/panels/trails/trail_list_row.h"

#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

namespace {

constexpr float rowButtonWidth = 26.0F;

} // namespace

RowLines rowLines(const Theme& theme) {
  return {theme.px(22.0F), theme.px(22.0F) + theme.rowHeight()};
}

void fillRow(PanelContext& context, bool selected) {
  const Theme& theme = context.theme;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end{corner.x + ImGui::GetContentRegionAvail().x, corner.y + rowLines(theme).whole};
  const bool hovered = ImGui::IsMouseHoveringRect(corner, end) && ImGui::IsWindowHovered();
  if (selected || hovered) {
    const ImU32 fill = selected ? faded(theme.colours.accentQuiet, 0.7F) : theme.colours.raised;
    ImGui::GetWindowDrawList()->AddRectFilled(corner, end, fill, theme.corner());
  }
}

RowClicks rowText(PanelContext& context, const RowText& row, int buttons) {
  const WidgetContext widgets = widgetsOf(context);
  const Theme& theme = context.theme;
  const RowLines lines = rowLines(theme);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float left = width - theme.px(rowButtonWidth) * static_cast<float>(buttons);
  const Control title = takePlace(widgets, row.id, {width, lines.name});
  drawText(widgets, theme.fonts.body, {{corner.x, corner.y + theme.px(2.0F)}, title.box.max}, row.colour,
           row.title);
  tooltip(widgets, row.help);
  ImGui::SetCursorScreenPos({corner.x, corner.y + lines.name});
  const Control detail = takePlace(widgets, row.id + "/detail", {left, lines.whole - lines.name});
  drawText(widgets, theme.fonts.label,
           {detail.box.min, {detail.box.max.x, detail.box.max.y + theme.px(1.0F)}}, theme.colours.quietText,
           row.detail);
  tooltip(widgets, row.help);
  ImGui::SetCursorScreenPos({corner.x + left, corner.y + lines.name});
  const bool hovered = title.hovered || detail.hovered;
  return {title.clicked || detail.clicked, hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left),
          hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right)};
}

bool rowButton(PanelContext& context, const std::string& id, const char* iconText, const char* fallback,
               bool on, const Help& help) {
  ButtonSpec spec;
  spec.id = id;
  spec.icon = iconText;
  spec.fallback = fallback;
  spec.emphasis = Emphasis::quiet;
  spec.on = on;
  spec.help = help;
  spec.width = context.theme.px(rowButtonWidth);
  const bool clicked = button(widgetsOf(context), spec);
  ImGui::SameLine(0.0F, 0.0F);
  return clicked;
}

} // namespace stretch::ui

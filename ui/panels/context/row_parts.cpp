#include "ui/panels/context/row_parts.h"

#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/widgets/icons.h"

namespace stretch::ui {

namespace {

std::size_t fittingParts(const std::vector<RowControl>& parts, float available, float buttonWidth) {
  float whole = 0.0F;
  for (const RowControl& part : parts) {
    whole += part.width;
  }
  if (whole <= available) {
    return parts.size();
  }
  float used = buttonWidth;
  std::size_t count = 0;
  while (count < parts.size() && used + parts[count].width <= available) {
    used += parts[count].width;
    ++count;
  }
  return count;
}

} // namespace

void rowOfParts(PanelContext& context, const std::string& id, float available,
                const std::vector<RowControl>& parts) {
  const Theme& theme = context.theme;
  const float buttonWidth = theme.px(30.0F);
  const std::size_t shown = fittingParts(parts, available, buttonWidth + theme.px(4.0F));
  for (std::size_t i = 0; i < shown; ++i) {
    parts[i].draw();
  }
  if (shown == parts.size()) {
    return;
  }
  const std::string popup = id + "/list";
  const ButtonSpec more{.id = id,
                        .icon = icon::ellipsis,
                        .help = {"More", "What has no room in this row.", {}},
                        .emphasis = Emphasis::quiet,
                        .width = buttonWidth,
                        .fallback = "..."};
  if (button(widgetsOf(context), more)) {
    ImGui::OpenPopup(popup.c_str());
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.unit(), theme.unit()));
  if (ImGui::BeginPopup(popup.c_str())) {
    if (keyPressed(ImGuiKey_Escape)) {
      ImGui::CloseCurrentPopup();
    }
    for (std::size_t i = shown; i < parts.size(); ++i) {
      parts[i].draw();
      ImGui::NewLine();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  ImGui::SameLine(0.0F, theme.px(4.0F));
}

} // namespace stretch::ui

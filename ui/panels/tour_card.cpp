#include <fmt/format.h>

#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void tourContent(PanelContext& context, const TourCard& card) {
  const WidgetContext widgets = widgetsOf(context);
  const Theme& theme = context.theme;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const Rect row{corner, {corner.x + width, corner.y + theme.px(22.0F)}};
  drawText(widgets, theme.fonts.strong, row, theme.colours.text, card.title);
  drawText(widgets, theme.fonts.label, row, theme.colours.quietText,
           fmt::format("{} of {}", card.step + 1, card.steps), 1.0F);
  ImGui::Dummy({width, row.height()});
  note(widgets, card.text);
  verticalSpace(widgets, 4.0F);
  const ImVec2 keyCorner = ImGui::GetCursorScreenPos();
  if (!card.key.empty()) {
    keyCap(widgets, {keyCorner.x, keyCorner.y + theme.px(4.0F)}, card.key);
  }
  const float buttonWidth = theme.px(110.0F);
  ImGui::SetCursorScreenPos({corner.x + width - buttonWidth, keyCorner.y});
  commandButton(context, {.command = command::tourEnd,
                          .text = "End the tour",
                          .emphasis = Emphasis::quiet,
                          .width = buttonWidth});
}

} // namespace

void drawTour(PanelContext& context, const Rect& picture) {
  if (!context.status.tour) {
    return;
  }
  const Theme& theme = context.theme;
  const float margin = theme.px(12.0F);
  const float width = std::min(theme.px(300.0F), picture.width() - 2.0F * margin);
  if (width < theme.px(140.0F)) {
    return;
  }
  ImGui::SetNextWindowPos({picture.min.x + margin, picture.max.y - margin}, ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::SetNextWindowSize({width, 0.0F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme.colours.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, theme.colours.accent);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, theme.px(1.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {margin, margin});
  if (ImGui::Begin("tour", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav)) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    context.items.add("tour", corner, {corner.x + size.x, corner.y + size.y});
    tourContent(context, *context.status.tour);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor(2);
}

} // namespace stretch::ui

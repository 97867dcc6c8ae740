#include <fmt/format.h>

#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
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

/// The step in one row, where the picture is too small for more; the mouse on it shows its text.
void tourRow(PanelContext& context, const TourCard& card) {
  const WidgetContext widgets = widgetsOf(context);
  const Theme& theme = context.theme;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = theme.px(24.0F);
  const float buttonWidth = theme.px(60.0F);
  const Control place = takePlace(widgets, "tour/step",
                                  {ImGui::GetContentRegionAvail().x - buttonWidth - theme.unit(), height});
  tooltip(widgets, {card.title, card.text, {}});
  const float key =
      card.key.empty() ? 0.0F : keyCap(widgets, {corner.x, corner.y + theme.px(3.0F)}, card.key);
  const Rect row{{corner.x + key + (key > 0.0F ? theme.unit() : 0.0F), corner.y}, place.box.max};
  const std::string count = fmt::format("{} of {}", card.step + 1, card.steps);
  const float countWidth = textSize(theme.fonts.label, count).x + theme.unit();
  drawText(widgets, theme.fonts.strong, {row.min, {row.max.x - countWidth, row.max.y}}, theme.colours.text,
           card.title);
  drawText(widgets, theme.fonts.label, row, theme.colours.quietText, count, 1.0F);
  ImGui::SameLine(0.0F, theme.unit());
  commandButton(
      context,
      {.command = command::tourEnd, .text = "End", .emphasis = Emphasis::quiet, .width = buttonWidth});
}

} // namespace

void drawTour(PanelContext& context, const Rect& picture) {
  if (!context.status.tour) {
    return;
  }
  const Theme& theme = context.theme;
  const bool isSmall = picture.height() < theme.px(300.0F);
  const float margin = theme.px(isSmall ? 6.0F : 12.0F);
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
    isSmall ? tourRow(context, *context.status.tour) : tourContent(context, *context.status.tour);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor(2);
}

} // namespace stretch::ui

#include "ui/widgets/dropdown.h"

#include <algorithm>

#include <imgui_stdlib.h>

namespace stretch::ui {

namespace {

void drawClosed(const WidgetContext& context, const Control& control, const std::string& text) {
  const Theme& theme = context.theme;
  const ThemeColours& colours = theme.colours;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(control.box.min, control.box.max, control.hovered ? colours.hovered : colours.raised,
                      theme.corner());
  if (theme.kind != ThemeKind::dark) {
    list->AddRect(control.box.min, control.box.max, colours.border, theme.corner());
  }
  const float half = theme.px(3.5F);
  const ImVec2 mark(control.box.max.x - theme.px(14.0F), control.box.centre().y);
  list->AddTriangleFilled({mark.x - half, mark.y - half * 0.6F}, {mark.x + half, mark.y - half * 0.6F},
                          {mark.x, mark.y + half * 0.8F}, colours.quietText);
  drawText(
      context, theme.fonts.body,
      {{control.box.min.x + theme.unit(), control.box.min.y}, {mark.x - theme.unit(), control.box.max.y}},
      colours.text, text);
}

int choiceList(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
               int selected, float width) {
  const Theme& theme = context.theme;
  int chosen = -1;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Choice& choice = choices[i];
    const bool isSelected = static_cast<int>(i) == selected;
    const Control row =
        takePlace(context, id + "/" + choice.text, {width, theme.rowHeight()}, choice.enabled);
    if (row.visible) {
      const ThemeColours& colours = theme.colours;
      if (row.hovered && choice.enabled) {
        ImGui::GetWindowDrawList()->AddRectFilled(row.box.min, row.box.max, colours.hovered, theme.corner());
      }
      const Rect text{{row.box.min.x + theme.unit(), row.box.min.y},
                      {row.box.max.x - theme.unit(), row.box.max.y}};
      const ImU32 colour = isSelected       ? colours.accent
                           : choice.enabled ? colours.text
                                            : faded(colours.text, 0.4F);
      drawText(context, theme.fonts.body, text, colour, choice.text);
      if (choice.marked) {
        ImGui::GetWindowDrawList()->AddCircleFilled({text.max.x - theme.px(4.0F), row.box.centre().y},
                                                    theme.px(3.5F), colours.accent);
      }
    }
    if (isSelected && ImGui::IsWindowAppearing()) {
      ImGui::SetScrollHereY(0.5F);
    }
    tooltip(context, choice.help);
    chosen = row.clicked ? static_cast<int>(i) : chosen;
  }
  return chosen;
}

float listWidth(const Theme& theme, const std::vector<Choice>& choices, float least) {
  float width = least;
  for (const Choice& choice : choices) {
    width = std::max(width, textSize(theme.fonts.body, choice.text).x + theme.unit() * 2.0F + theme.px(4.0F));
  }
  return width;
}

/// Below the field, or above it where there is more room; as long as the screen lets it be.
void placeList(const Theme& theme, const Rect& field, std::size_t count) {
  const float gap = theme.px(2.0F);
  const float wanted = static_cast<float>(count) * (theme.rowHeight() + theme.px(1.0F)) + theme.px(8.0F);
  const float above = field.min.y - gap - theme.unit();
  const float below = ImGui::GetIO().DisplaySize.y - field.max.y - gap - theme.unit();
  const bool isBelow = wanted <= below || below >= above;
  const float height = std::min({wanted, isBelow ? below : above, theme.px(480.0F)});
  ImGui::SetNextWindowPos({field.min.x, isBelow ? field.max.y + gap : field.min.y - gap - height});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {theme.px(480.0F), height});
}

} // namespace

int dropdown(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
             int selected, const Help& help, float width, const char* none) {
  const Theme& theme = context.theme;
  const float fieldWidth = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
  const Control control = takePlace(context, id, {fieldWidth, theme.rowHeight()});
  const bool valid = selected >= 0 && selected < static_cast<int>(choices.size());
  if (control.visible) {
    drawClosed(context, control,
               valid ? choices[static_cast<std::size_t>(selected)].text : std::string(none));
  }
  tooltip(context, help);
  const std::string popup = id + "/list";
  if (control.clicked) {
    ImGui::OpenPopup(popup.c_str());
  }
  int chosen = -1;
  placeList(theme, control.box, choices.size());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(4.0F), theme.px(4.0F)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, theme.px(1.0F)));
  if (ImGui::BeginPopup(popup.c_str())) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
      ImGui::CloseCurrentPopup();
    }
    chosen =
        choiceList(context, id, choices, selected, listWidth(theme, choices, fieldWidth - theme.px(8.0F)));
    if (chosen >= 0) {
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  return chosen;
}

EditPhase editText(const WidgetContext& context, const std::string& id, const std::string& hint,
                   std::string& text, float width, bool focusNow) {
  const Theme& theme = context.theme;
  const float fieldWidth = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
  if (focusNow) {
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(fieldWidth);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, theme.colours.sunken);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.0F);
  const bool changed = ImGui::InputTextWithHint(("##" + id).c_str(), hint.c_str(), &text);
  const EditPhase phase{changed, ImGui::IsItemDeactivated()};
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  context.items.add(id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  tooltip(context, {.text = hint});
  return phase;
}

bool textField(const WidgetContext& context, const std::string& id, const std::string& hint,
               std::string& text, float width, bool focusNow) {
  return editText(context, id, hint, text, width, focusNow).changed;
}

} // namespace stretch::ui

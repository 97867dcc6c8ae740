#include "ui/widgets/dropdown.h"

#include <algorithm>
#include <cctype>
#include <cfloat>

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
  const Rect place{{control.box.min.x + theme.unit(), control.box.min.y},
                   {mark.x - theme.unit(), control.box.max.y}};
  drawText(context, theme.fonts.body, place, colours.text,
           cutInMiddle(theme.fonts.body, text, place.width()));
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
      drawText(context, theme.fonts.label, text, faded(theme.colours.quietText, choice.enabled ? 1.0F : 0.4F),
               choice.note, 1.0F);
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
    const float note =
        choice.note.empty() ? 0.0F : textSize(theme.fonts.label, choice.note).x + theme.unit() * 3.0F;
    const float mark = choice.marked ? theme.unit() * 2.0F : 0.0F;
    width = std::max(width, textSize(theme.fonts.body, choice.text).x + theme.unit() * 2.0F + theme.px(4.0F) +
                                note + mark);
  }
  return std::min(width, ImGui::GetIO().DisplaySize.x - theme.unit() * 4.0F);
}

/// Below the field, or above it where there is more room; as long as the window lets it be, and inside of it.
void placeList(const Theme& theme, const Rect& field, float width, float rows) {
  const float gap = theme.px(2.0F);
  const float wanted = rows * (theme.rowHeight() + theme.px(1.0F)) + theme.px(8.0F);
  const float above = field.min.y - gap - theme.unit();
  const float below = ImGui::GetIO().DisplaySize.y - field.max.y - gap - theme.unit();
  const bool isBelow = wanted <= below || below >= above;
  const float height = std::min({wanted, isBelow ? below : above, theme.px(480.0F)});
  const float whole = width + theme.px(8.0F) + (wanted > height ? ImGui::GetStyle().ScrollbarSize : 0.0F);
  const float left =
      std::max(0.0F, std::min(field.min.x, ImGui::GetIO().DisplaySize.x - whole - theme.unit()));
  ImGui::SetNextWindowPos({left, isBelow ? field.max.y + gap : field.min.y - gap - height});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {FLT_MAX, height});
}

/// The choices that hold every letter of what was typed, in either case; all without it.
std::vector<Choice> matching(const std::vector<Choice>& choices, const std::string& typed,
                             std::vector<int>& indices) {
  const auto lower = [](std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  };
  const std::string wanted = lower(typed);
  std::vector<Choice> found;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (lower(choices[i].text).find(wanted) != std::string::npos) {
      found.push_back(choices[i]);
      indices.push_back(static_cast<int>(i));
    }
  }
  return found;
}

/// The list with a field that filters it; the index among all choices, or -1.
int openList(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
             int selected, float width, std::string* filter) {
  std::vector<int> indices;
  if (filter != nullptr) {
    if (ImGui::IsWindowAppearing()) {
      filter->clear();
    }
    textField(context, id + "/search", "Search", *filter, width, ImGui::IsWindowAppearing());
  }
  const std::vector<Choice> shown = matching(choices, filter == nullptr ? "" : *filter, indices);
  const auto place = std::find(indices.begin(), indices.end(), selected);
  const int shownSelected = place == indices.end() ? -1 : static_cast<int>(place - indices.begin());
  int chosen = choiceList(context, id, shown, shownSelected, width);
  const bool entered = filter != nullptr && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
  chosen = entered && !shown.empty() ? 0 : chosen;
  return chosen < 0 ? -1 : indices[static_cast<std::size_t>(chosen)];
}

} // namespace

int dropdown(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
             int selected, const Help& help, float width, const char* none, std::string* filter) {
  const Theme& theme = context.theme;
  const float fieldWidth = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
  const Control control = takePlace(context, id, {fieldWidth, theme.rowHeight()});
  const bool valid = selected >= 0 && selected < static_cast<int>(choices.size());
  const std::string closed = valid ? choices[static_cast<std::size_t>(selected)].text : std::string(none);
  if (control.visible) {
    drawClosed(context, control, closed);
  }
  const bool cut = textSize(theme.fonts.body, closed).x > fieldWidth - theme.unit() * 2.0F - theme.px(14.0F);
  tooltip(context, cut ? Help{closed, help.text, help.keyText} : help);
  const std::string popup = id + "/list";
  if (control.clicked) {
    ImGui::OpenPopup(popup.c_str());
  }
  int chosen = -1;
  const float rowWidth = listWidth(theme, choices, fieldWidth - theme.px(8.0F));
  placeList(theme, control.box, rowWidth, static_cast<float>(choices.size() + (filter == nullptr ? 0 : 1)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(4.0F), theme.px(4.0F)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, theme.px(1.0F)));
  if (ImGui::BeginPopup(popup.c_str())) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
      ImGui::CloseCurrentPopup();
    }
    chosen = openList(context, id, choices, selected, rowWidth, filter);
    if (chosen >= 0) {
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  return chosen;
}

EditPhase editText(const WidgetContext& context, const std::string& id, const std::string& hint,
                   std::string& text, float width, bool focusNow, bool selectAll) {
  const Theme& theme = context.theme;
  const float fieldWidth = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
  if (focusNow) {
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(fieldWidth);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, theme.colours.sunken);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.0F);
  const bool changed = ImGui::InputTextWithHint(("##" + id).c_str(), hint.c_str(), &text,
                                                selectAll ? ImGuiInputTextFlags_AutoSelectAll : 0);
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

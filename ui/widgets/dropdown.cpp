#include "ui/widgets/dropdown.h"

#include <algorithm>
#include <cfloat>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "ui/widgets/fuzzy.h"

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

/// `lit` is drawn as if the mouse was on it; -1 is none.
int choiceList(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
               int selected, float width, int lit = -1) {
  const Theme& theme = context.theme;
  int chosen = -1;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Choice& choice = choices[i];
    const bool isSelected = static_cast<int>(i) == selected;
    const Control row =
        takePlace(context, id + "/" + choice.text, {width, theme.rowHeight()}, choice.enabled);
    if (row.visible) {
      const ThemeColours& colours = theme.colours;
      if ((row.hovered || static_cast<int>(i) == lit) && choice.enabled) {
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

/// Where an open list stands, in screen pixels.
struct ListPlace {
  bool isBelow = true;     ///< The field that opened it; else above.
  float width = 0.0F;      ///< Of its rows and what scrolls them.
  float rowsHeight = 0.0F; ///< Of what is shown of its rows, at most.
};

float heightOfRows(const Theme& theme, std::size_t rows) {
  return static_cast<float>(rows) * (theme.rowHeight() + theme.px(1.0F));
}

/// Below the field, or above it where there is more room; as long as the window lets it be, and inside of it.
/// It stays at the field when it gets shorter.
ListPlace placeList(const Theme& theme, const Rect& field, float rowWidth, std::size_t rows, bool hasFilter) {
  const float gap = theme.px(2.0F);
  const float besideRows = theme.px(8.0F) + heightOfRows(theme, hasFilter ? 1 : 0);
  const float wanted = heightOfRows(theme, rows) + besideRows;
  const float above = field.min.y - gap - theme.unit();
  const float below = ImGui::GetIO().DisplaySize.y - field.max.y - gap - theme.unit();
  const float most = std::min(wanted, theme.px(480.0F));
  const bool isBelow = most <= below || below >= above;
  const float height = std::min(most, isBelow ? below : above);
  const float width = rowWidth + (wanted > height ? ImGui::GetStyle().ScrollbarSize : 0.0F);
  const float left = std::max(
      0.0F, std::min(field.min.x, ImGui::GetIO().DisplaySize.x - width - theme.px(8.0F) - theme.unit()));
  ImGui::SetNextWindowPos({left, isBelow ? field.max.y + gap : field.min.y - gap}, ImGuiCond_Always,
                          {0.0F, isBelow ? 0.0F : 1.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {FLT_MAX, height});
  return {isBelow, width, height - besideRows};
}

/// Indices of the choices that hold every word that was typed; all without one.
std::vector<int> matching(const std::vector<Choice>& choices, const std::string& typed) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (holdsWords(typed, choices[i].text)) {
      indices.push_back(static_cast<int>(i));
    }
  }
  return indices;
}

/// The field that filters a list; what Enter chooses in it: the first match, the selected one while nothing
/// is typed, or -1.
int searchField(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
                int selected, float width, std::string& filter) {
  // Nobody else needs the keys while the list is open, also after an Enter that found nothing.
  const bool isFree = ImGui::GetActiveID() == 0;
  textField(context, id + "/search", "Search", filter, width, isFree);
  const bool entered = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
  if (!entered) {
    return -1;
  }
  const std::vector<int> found = matching(choices, filter);
  return found.empty() ? -1 : filter.empty() ? selected : found.front();
}

/// The choices that answer the filter, the first of which Enter takes; they scroll and leave the field where
/// it is. The index among all choices, or -1.
int filteredList(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
                 int selected, const ListPlace& place, float rowWidth, const std::string& filter) {
  const std::vector<int> indices = matching(choices, filter);
  std::vector<Choice> shown;
  shown.reserve(indices.size());
  for (const int index : indices) {
    shown.push_back(choices[static_cast<std::size_t>(index)]);
  }
  const auto found = std::find(indices.begin(), indices.end(), selected);
  const int shownSelected = found == indices.end() ? -1 : static_cast<int>(found - indices.begin());
  const float wanted = heightOfRows(context.theme, std::max<std::size_t>(1, shown.size()));
  ImGui::BeginChild((id + "/rows").c_str(), {place.width, std::min(wanted, place.rowsHeight)});
  if (shown.empty()) {
    const Control row = takePlace(context, id + "/none", {rowWidth, context.theme.rowHeight()}, false);
    drawText(context, context.theme.fonts.body,
             {{row.box.min.x + context.theme.unit(), row.box.min.y}, row.box.max},
             context.theme.colours.quietText, "No match");
  }
  const int chosen = choiceList(context, id, shown, shownSelected, rowWidth, filter.empty() ? -1 : 0);
  ImGui::EndChild();
  return chosen < 0 ? -1 : indices[static_cast<std::size_t>(chosen)];
}

/// The list with a field that filters it, which stands next to the field that opened the list; the index
/// among all choices, or -1.
int searchedList(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
                 int selected, const ListPlace& place, float rowWidth, std::string& filter) {
  if (ImGui::IsWindowAppearing()) {
    filter.clear();
  }
  int entered = -1;
  if (place.isBelow) {
    entered = searchField(context, id, choices, selected, place.width, filter);
  }
  const int clicked = filteredList(context, id, choices, selected, place, rowWidth, filter);
  if (!place.isBelow) {
    entered = searchField(context, id, choices, selected, place.width, filter);
  }
  return entered >= 0 ? entered : clicked;
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
  const ListPlace place = placeList(theme, control.box, rowWidth, choices.size(), filter != nullptr);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(4.0F), theme.px(4.0F)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, theme.px(1.0F)));
  if (ImGui::BeginPopup(popup.c_str())) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
      ImGui::CloseCurrentPopup();
    }
    chosen = filter == nullptr ? choiceList(context, id, choices, selected, rowWidth)
                               : searchedList(context, id, choices, selected, place, rowWidth, *filter);
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

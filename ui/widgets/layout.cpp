#include "ui/widgets/layout.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ui/widgets/icons.h"

namespace stretch::ui {

namespace {

/// Width of the labels of rows: a third of the panel, within limits.
float labelColumn(const Theme& theme) {
  return std::clamp(std::floor(ImGui::GetContentRegionAvail().x * 0.33F), theme.px(56.0F), theme.px(96.0F));
}

ImU32 noticeColour(const ThemeColours& colours, NoticeKind kind) {
  switch (kind) {
  case NoticeKind::success:
    return colours.success;
  case NoticeKind::warning:
    return colours.warning;
  case NoticeKind::error:
    return colours.error;
  case NoticeKind::info:
    break;
  }
  return colours.quietText;
}

/// The same place, or the space before it: Dear ImGui breaks behind every full stop, in numbers too, and a
/// number keeps its "%".
const char* betweenWords(const char* start, const char* stop, const char* end) {
  const auto breaksHere = [&](const char* at) {
    return at == end || (*at == ' ' && !(at + 1 < end && at[1] == '%'));
  };
  const char* at = stop;
  while (at > start && !breaksHere(at)) {
    --at;
  }
  return at > start ? at : stop; // A word that is wider than the line is broken.
}

const ImFont* labelFont(const Theme& theme) {
  return theme.fonts.label != nullptr ? theme.fonts.label : ImGui::GetFont();
}

float labelLineHeight(const Theme& theme) {
  return labelFont(theme)->FontSize + theme.px(2.0F);
}

/// Draws lines below each other from the box's top on; answers where they end.
float drawLines(const WidgetContext& context, const Rect& box, ImU32 colour,
                const std::vector<std::string_view>& lines, float alignment) {
  const float line = labelLineHeight(context.theme);
  float y = box.min.y;
  for (const std::string_view text : lines) {
    drawText(context, context.theme.fonts.label, {{box.min.x, y}, {box.max.x, y + line}}, colour, text,
             alignment);
    y += line;
  }
  return y;
}

/// The face of a notice: a wash and an edge in its colour.
void drawNoticeFace(const Theme& theme, const Rect& box, ImU32 colour, float wash) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled(box.min, box.max, mixed(theme.colours.panel, colour, wash), theme.corner());
  list->AddRectFilled(box.min, {box.min.x + theme.px(3.0F), box.max.y}, colour, theme.corner(),
                      ImDrawFlags_RoundCornersLeft);
}

} // namespace

void labelledRow(const WidgetContext& context, const std::string& label, const Help& help) {
  const Theme& theme = context.theme;
  const Control control =
      takePlace(context, "label:" + label, {labelColumn(theme), theme.rowHeight()}, false);
  drawText(context, theme.fonts.label, control.box, theme.colours.quietText, label);
  tooltip(context, help);
  ImGui::SameLine(0.0F, theme.unit());
}

void valueRow(const WidgetContext& context, const std::string& label, const std::string& value,
              const Help& help) {
  const Theme& theme = context.theme;
  const float height = theme.px(22.0F);
  const Control control =
      takePlace(context, "row:" + label, {ImGui::GetContentRegionAvail().x, height}, false);
  if (control.visible) {
    const float split = control.box.min.x + labelColumn(theme) + theme.unit();
    drawText(context, theme.fonts.label, {control.box.min, {split - theme.unit(), control.box.max.y}},
             theme.colours.quietText, label);
    drawText(context, theme.fonts.label, {{split, control.box.min.y}, control.box.max}, theme.colours.text,
             value);
  }
  tooltip(context, help.title.empty() ? Help{.title = value, .text = help.text} : help);
}

bool section(const WidgetContext& context, const std::string& id, const std::string& title,
             std::vector<std::string>& closedSections) {
  const Theme& theme = context.theme;
  const auto found = std::find(closedSections.begin(), closedSections.end(), id);
  const bool open = found == closedSections.end();
  verticalSpace(context, 2.0F);
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, theme.px(28.0F)});
  if (control.visible) {
    const ThemeColours& colours = theme.colours;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddLine({control.box.min.x, control.box.min.y}, {control.box.max.x, control.box.min.y},
                  faded(colours.border, 0.7F));
    const ImU32 colour = control.hovered ? colours.text : colours.quietText;
    const float half = theme.px(3.5F);
    const ImVec2 centre(control.box.min.x + theme.px(5.0F), control.box.centre().y);
    if (open) {
      list->AddTriangleFilled({centre.x - half, centre.y - half * 0.6F},
                              {centre.x + half, centre.y - half * 0.6F}, {centre.x, centre.y + half * 0.8F},
                              colour);
    } else {
      list->AddTriangleFilled({centre.x - half * 0.6F, centre.y - half}, {centre.x + half * 0.8F, centre.y},
                              {centre.x - half * 0.6F, centre.y + half}, colour);
    }
    const Rect text{{control.box.min.x + theme.px(16.0F), control.box.min.y}, control.box.max};
    drawText(context, theme.fonts.label, text,
             control.hovered ? colours.text : mixed(colours.text, colours.quietText, 0.35F), title);
  }
  tooltip(context, {.text = open ? "Click to fold this section." : "Click to open this section."});
  if (control.clicked && open) {
    closedSections.push_back(id);
  } else if (control.clicked) {
    closedSections.erase(found);
  }
  return open;
}

void panelTitle(const WidgetContext& context, const char* iconText, const std::string& title,
                float reserved) {
  const Theme& theme = context.theme;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x - reserved);
  ImGui::Dummy({width, theme.rowHeight()});
  const Rect box{corner, {corner.x + width, corner.y + theme.rowHeight()}};
  const std::string text = theme.fonts.hasIcons ? std::string(iconText) + "  " + title : title;
  drawText(context, theme.fonts.strong, box, theme.colours.text, text);
}

std::vector<std::string_view> wrapped(const ImFont* font, std::string_view text, float width,
                                      std::size_t most) {
  std::vector<std::string_view> lines;
  const char* start = text.data();
  const char* const end = start + text.size();
  while (start < end) {
    const char* stop =
        lines.size() + 1 == most
            ? end
            : std::max(start + 1, font->CalcWordWrapPositionA(1.0F, start, end, std::max(1.0F, width)));
    stop = betweenWords(start, stop, end);
    lines.emplace_back(start, static_cast<std::size_t>(stop - start));
    start = stop;
    while (start < end && *start == ' ') {
      ++start;
    }
  }
  return lines;
}

void note(const WidgetContext& context, const std::string& text) {
  ImGui::PushFont(context.theme.fonts.label);
  ImGui::PushStyleColor(ImGuiCol_Text, context.theme.colours.quietText);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void notice(const WidgetContext& context, NoticeKind kind, const std::string& text) {
  const Theme& theme = context.theme;
  const float padding = theme.unit();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImFont* font = theme.fonts.label != nullptr ? theme.fonts.label : ImGui::GetFont();
  const float wrap = std::max(1.0F, width - padding * 2.0F - theme.px(3.0F));
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap, text.c_str());
  const float height = size.y + theme.px(12.0F);
  ImGui::Dummy({width, height});
  drawNoticeFace(theme, {corner, {corner.x + width, corner.y + height}}, noticeColour(theme.colours, kind),
                 0.10F);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddText(font, font->FontSize, {corner.x + padding + theme.px(3.0F), corner.y + theme.px(6.0F)},
                theme.colours.text, text.c_str(), nullptr, wrap);
}

bool noticeLines(const WidgetContext& context, const std::string& id, NoticeKind kind,
                 const std::string& text, const std::string& more, bool whole) {
  const Theme& theme = context.theme;
  constexpr std::size_t cutLines = 2;
  const ImVec2 padding(theme.px(11.0F), theme.px(5.0F));
  const float moreWidth = textSize(theme.fonts.label, more).x;
  const float width = ImGui::GetContentRegionAvail().x;
  const float textWidth = width - padding.x - moreWidth - theme.unit() * 2.0F;
  const std::vector<std::string_view> all = wrapped(labelFont(theme), text, textWidth);
  const std::size_t lineCount = whole ? std::max(cutLines, all.size()) : cutLines;
  const float line = labelLineHeight(theme);
  const Control place =
      takePlace(context, id, {width, static_cast<float>(lineCount) * line + padding.y * 2.0F});
  drawNoticeFace(theme, place.box, noticeColour(theme.colours, kind), place.hovered ? 0.22F : 0.10F);
  const ImVec2 corner(place.box.min.x + padding.x, place.box.min.y + padding.y);
  drawLines(context, {corner, {corner.x + textWidth, place.box.max.y}}, theme.colours.text,
            whole ? all : wrapped(labelFont(theme), text, textWidth, cutLines), 0.0F);
  const float right = place.box.max.x - theme.unit();
  drawText(context, theme.fonts.label, {{right - moreWidth, corner.y}, {right, corner.y + line}},
           place.hovered ? theme.colours.text : theme.colours.quietText, more);
  tooltip(context, {.text = whole ? "Click to fold the messages." : text});
  if (place.clicked && !whole && all.size() > cutLines) {
    ImGui::Dummy({width, static_cast<float>(all.size() - cutLines) * line}); // What it takes from now on.
  }
  return place.clicked;
}

void emptyState(const WidgetContext& context, const char* iconText, const std::string& title,
                const std::string& text) {
  const Theme& theme = context.theme;
  verticalSpace(context, 12.0F);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  float y = corner.y;
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImFont* large = theme.fonts.heading != nullptr ? theme.fonts.heading : ImGui::GetFont();
  if (theme.fonts.hasIcons) {
    const float size = large->FontSize * 1.2F;
    const ImVec2 iconSize = large->CalcTextSizeA(size, FLT_MAX, 0.0F, iconText);
    list->AddText(large, size, {corner.x + (width - iconSize.x) * 0.5F, y},
                  faded(theme.colours.quietText, 0.7F), iconText);
    y += iconSize.y + theme.unit();
  }
  drawText(context, theme.fonts.body, {{corner.x, y}, {corner.x + width, y + theme.px(20.0F)}},
           theme.colours.text, title, 0.5F);
  y += theme.px(24.0F);
  y = drawLines(context, {{corner.x + theme.unit(), y}, {corner.x + width - theme.unit(), y}},
                theme.colours.quietText, wrapped(labelFont(theme), text, width - theme.unit() * 2.0F), 0.5F);
  ImGui::SetCursorScreenPos({corner.x, y});
  ImGui::Dummy({width, theme.px(1.0F)});
  verticalSpace(context, 8.0F);
}

float keyCap(const WidgetContext& context, const ImVec2& corner, const std::string& text) {
  const Theme& theme = context.theme;
  const float height = theme.px(18.0F);
  const float width = std::max(height, std::ceil(textSize(theme.fonts.label, text).x + theme.px(10.0F)));
  const Rect box{corner, {corner.x + width, corner.y + height}};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(box.min, box.max, theme.colours.raised, theme.px(3.0F));
  list->AddRect(box.min, box.max, theme.colours.border, theme.px(3.0F));
  drawText(context, theme.fonts.label, box, theme.colours.text, text, 0.5F);
  return width;
}

void verticalSpace(const WidgetContext& context, float designPixels) {
  ImGui::Dummy({0.0F, std::max(0.0F, context.theme.px(designPixels) - ImGui::GetStyle().ItemSpacing.y)});
}

void separator(const WidgetContext& context) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({width, context.theme.px(1.0F)});
  ImGui::GetWindowDrawList()->AddLine(corner, {corner.x + width, corner.y},
                                      faded(context.theme.colours.border, 0.7F));
}

} // namespace stretch::ui

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string_view>
#include <vector>

#include <imgui_internal.h>

#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

constexpr float fadeSeconds = 0.4F;

ImU32 toastColour(const ThemeColours& colours, ToastKind kind) {
  switch (kind) {
  case ToastKind::success:
    return colours.success;
  case ToastKind::warning:
    return colours.warning;
  case ToastKind::error:
    return colours.error;
  case ToastKind::info:
    break;
  }
  return colours.accent;
}

const char* toastIcon(ToastKind kind) {
  return kind == ToastKind::success ? icon::check : kind == ToastKind::info ? icon::info : icon::warning;
}

/// How messages are set: a small picture is left to the character, with smaller text in narrower edges.
struct ToastStyle {
  ImFont* font = nullptr;
  ImVec2 padding;
  float iconColumn = 0.0F; ///< 0: a bar in the message's colour instead of an icon.
  float widest = 0.0F;     ///< Of a line.
  std::size_t mostLines = 2;
};

ToastStyle toastStyle(const Theme& theme, const Rect& picture) {
  constexpr float mostOfHeight = 0.25F;
  const float wanted = theme.px(420.0F);
  ToastStyle style;
  const bool isSmall = picture.width() < wanted + theme.px(54.0F) + 2.0F * theme.unit();
  ImFont* const font = isSmall ? theme.fonts.label : theme.fonts.body;
  style.font = font != nullptr ? font : ImGui::GetFont();
  style.padding = isSmall ? ImVec2(theme.px(10.0F), theme.px(4.0F)) : ImVec2(theme.px(14.0F), theme.px(9.0F));
  style.iconColumn = theme.fonts.hasIcons && !isSmall ? theme.px(26.0F) : 0.0F;
  const float room = picture.width() - style.iconColumn - 2.0F * (style.padding.x + theme.unit());
  style.widest = std::clamp(room, theme.px(80.0F), wanted);
  const float lines = (mostOfHeight * picture.height() - 2.0F * style.padding.y) / style.font->FontSize;
  style.mostLines = std::max(style.mostLines, static_cast<std::size_t>(std::max(0.0F, lines)));
  return style;
}

/// Where a message stands and how its text runs.
struct ToastPlace {
  Rect box;
  std::vector<std::string_view> lines;
  bool isCut = false; ///< The last line holds more than is drawn of it.
};

/// Beside the character, on the wider side, where a message has room there; else all of the picture.
Rect roomFor(const Theme& theme, const Rect& picture, const std::optional<Rect>& figure) {
  constexpr float upperShare = 0.25F; // of the picture, where messages stand
  if (!figure || figure->min.y > picture.min.y + upperShare * picture.height()) {
    return picture;
  }
  const Rect left{picture.min, {std::min(figure->min.x, picture.max.x), picture.max.y}};
  const Rect right{{std::max(figure->max.x, picture.min.x), picture.min.y}, picture.max};
  const Rect& wider = left.width() > right.width() ? left : right;
  return wider.width() < theme.px(220.0F) ? picture : wider;
}

/// In the middle of the room's width, with its upper edge at `top`.
ToastPlace placeToast(const ToastStyle& style, const Rect& room, const Toast& message, float top) {
  ToastPlace place;
  place.lines = wrapped(style.font, message.text, style.widest);
  place.isCut = place.lines.size() > style.mostLines;
  float textWidth = place.isCut ? style.widest : 0.0F;
  for (const std::string_view line : place.lines) {
    textWidth = std::max(textWidth, textSize(style.font, line).x);
  }
  if (place.isCut) {
    place.lines = wrapped(style.font, message.text, style.widest, style.mostLines);
  }
  const float width = textWidth + style.iconColumn + 2.0F * style.padding.x;
  const float height = static_cast<float>(place.lines.size()) * style.font->FontSize + 2.0F * style.padding.y;
  const ImVec2 corner(std::floor(room.centre().x - 0.5F * width), std::floor(top));
  place.box = {corner, {corner.x + width, corner.y + height}};
  return place;
}

void drawToastText(const ToastStyle& style, const ToastPlace& place, ImU32 colour, ImDrawList& list) {
  ImGui::PushFont(style.font);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const float left = place.box.min.x + style.padding.x + style.iconColumn;
  const float right = place.box.max.x - style.padding.x + 1.0F;
  float y = place.box.min.y + style.padding.y;
  for (const std::string_view line : place.lines) {
    const ImVec2 size = textSize(style.font, line);
    ImGui::RenderTextEllipsis(&list, {left, y}, {right, y + size.y}, right, right, line.data(),
                              line.data() + line.size(), &size);
    y += style.font->FontSize;
  }
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void drawToast(const Theme& theme, const ToastStyle& style, const Toast& message, const ToastPlace& place,
               ImDrawList& list) {
  const Rect& box = place.box;
  const float opacity = std::clamp(message.secondsLeft / fadeSeconds, 0.0F, 1.0F);
  const float shadow = theme.px(2.0F);
  list.AddRectFilled({box.min.x - shadow, box.min.y}, {box.max.x + shadow, box.max.y + shadow * 2.0F},
                     faded(theme.colours.shadow, opacity * 0.6F), theme.px(8.0F));
  list.AddRectFilled(box.min, box.max, faded(theme.colours.raised, opacity), theme.px(6.0F));
  list.AddRect(box.min, box.max, faded(theme.colours.border, opacity), theme.px(6.0F));
  const ImU32 colour = faded(toastColour(theme.colours, message.kind), opacity);
  if (style.iconColumn > 0.0F) {
    list.AddText(style.font, style.font->FontSize, {box.min.x + style.padding.x, box.min.y + style.padding.y},
                 colour, toastIcon(message.kind));
  } else {
    list.AddRectFilled(box.min, {box.min.x + theme.px(4.0F), box.max.y}, colour, theme.px(6.0F),
                       ImDrawFlags_RoundCornersLeft);
  }
  drawToastText(style, place, faded(theme.colours.text, opacity), list);
}

/// The whole text of a message that is cut, while the mouse is on it; answers whether it is.
bool readsWhole(PanelContext& context, const Toast& message, const ToastPlace& place) {
  const bool reads = place.isCut && place.box.contains(ImGui::GetMousePos());
  if (reads) {
    tooltipNow(widgetsOf(context), {.text = message.text});
  }
  return reads;
}

} // namespace

void drawToasts(PanelContext& context, const Rect& picture, const std::optional<Rect>& figure,
                ImDrawList& under) {
  const Theme& theme = context.theme;
  const bool isDialogOpen = ImGui::GetTopMostPopupModal() != nullptr;
  const bool isAnyOpen = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (isAnyOpen && !isDialogOpen) {
    hideNews(context.ui);
  }
  const Rect room = roomFor(theme, picture, figure);
  ToastStyle style = toastStyle(theme, picture);
  style.widest =
      std::min(style.widest, room.width() - style.iconColumn - 2.0F * (style.padding.x + theme.unit()));
  ImDrawList& list = isDialogOpen ? *ImGui::GetForegroundDrawList() : under;
  float top = picture.min.y + theme.unit();
  int count = 0;
  for (Toast& message : context.ui.toasts) {
    const bool isNews = message.kind == ToastKind::info || message.kind == ToastKind::success;
    if (isDialogOpen && isNews) {
      continue; // Told when the dialog is closed.
    }
    const ToastPlace place = placeToast(style, room, message, top);
    if (count > 0 && place.box.max.y > picture.centre().y) {
      break; // Told when there is room.
    }
    drawToast(theme, style, message, place, list);
    context.items.add("toast/" + std::to_string(count++), place.box.min, place.box.max);
    context.items.items.back().explained = true; // By itself.
    const bool stays = !isDialogOpen && readsWhole(context, message, place);
    message.secondsLeft -= stays ? 0.0F : ImGui::GetIO().DeltaTime;
    top = place.box.max.y + theme.unit();
  }
  std::erase_if(context.ui.toasts, [](const Toast& toast) { return toast.secondsLeft <= 0.0F; });
}

} // namespace stretch::ui

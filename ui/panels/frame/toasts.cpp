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
  bool isLong = false; ///< It takes much of the picture's height.
};

/// A place for all messages: a part of the window, and at which of its edges they stand.
struct StackPlace {
  Rect room;
  bool isLow = false;
};

void addBoth(std::vector<StackPlace>& places, const Rect& room) {
  places.push_back({room, false});
  places.push_back({room, true});
}

/// Beside the character, the wider side first, where a message has room there; else all of the picture.
std::vector<StackPlace> placesInPicture(const Theme& theme, const MessageRoom& room) {
  constexpr float upperShare = 0.25F; // of the picture, where messages stand
  const Rect& picture = room.picture;
  std::vector<StackPlace> places;
  if (room.figure && room.figure->min.y <= picture.min.y + upperShare * picture.height()) {
    const Rect left{picture.min, {std::min(room.figure->min.x, picture.max.x), picture.max.y}};
    const Rect right{{std::max(room.figure->max.x, picture.min.x), picture.min.y}, picture.max};
    const bool isLeftWider = left.width() > right.width();
    for (const Rect& side : {isLeftWider ? left : right, isLeftWider ? right : left}) {
      if (side.width() >= theme.px(220.0F)) {
        addBoth(places, side);
      }
    }
  }
  addBoth(places, picture);
  return places;
}

/// Over the picture, else beside a dialog that takes the window's middle.
std::vector<StackPlace> placesByDialog(const Rect& picture, const Rect& dialog) {
  const ImGuiViewport& window = *ImGui::GetMainViewport();
  const Rect all{window.Pos, {window.Pos.x + window.Size.x, window.Pos.y + window.Size.y}};
  std::vector<StackPlace> places;
  addBoth(places, picture);
  places.push_back({{all.min, {all.max.x, dialog.min.y}}, false});
  places.push_back({{{all.min.x, dialog.max.y}, all.max}, true});
  places.push_back({{all.min, {dialog.min.x, all.max.y}}, false});
  places.push_back({{{dialog.max.x, all.min.y}, all.max}, false});
  return places;
}

/// In the middle of the room's width, with its upper edge at `top`.
ToastPlace placeToast(const ToastStyle& style, const Rect& room, const Toast& message, float top) {
  ToastPlace place;
  place.lines = wrapped(style.font, message.text, style.widest);
  place.isLong = place.lines.size() > style.mostLines;
  float textWidth = 0.0F;
  for (const std::string_view line : place.lines) {
    textWidth = std::max(textWidth, textSize(style.font, line).x);
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

/// A message with its place.
struct PlacedToast {
  Toast* message = nullptr;
  ToastPlace place;
};

/// Those that have room in the upper or the lower half of the place, one under the other.
std::vector<PlacedToast> placeToasts(const Theme& theme, ToastStyle style, const std::vector<Toast*>& shown,
                                     const StackPlace& at) {
  const float edges = style.iconColumn + 2.0F * (style.padding.x + theme.unit());
  style.widest = std::min(style.widest, std::max(at.room.width() - edges, theme.px(80.0F)));
  std::vector<PlacedToast> placed;
  float top = at.room.min.y + theme.unit();
  for (Toast* const message : shown) {
    ToastPlace place = placeToast(style, at.room, *message, top);
    if (!placed.empty() && place.box.max.y > at.room.centre().y) {
      break; // Told when there is room.
    }
    top = place.box.max.y + theme.unit();
    placed.push_back({message, std::move(place)});
  }
  const float down = at.isLow ? std::floor(at.room.max.y - top) : 0.0F;
  for (PlacedToast& toast : placed) {
    toast.place.box.min.y += down;
    toast.place.box.max.y += down;
  }
  return placed;
}

/// Whether all of it lies in its place, on nothing of `kept`.
bool isFree(const std::vector<PlacedToast>& placed, const Rect& room, const std::vector<Rect>& kept) {
  return std::ranges::all_of(placed, [&](const PlacedToast& toast) {
    const Rect& box = toast.place.box;
    const bool isInside = room.contains(box.min) && box.max.x <= room.max.x && box.max.y <= room.max.y;
    return isInside && std::ranges::none_of(kept, [&](const Rect& rect) { return rect.overlaps(box); });
  });
}

/// In the place of the frame before, else in the first one that is free of labels and of what is spared as
/// well and wide enough for a long message, else in the first that is without the labels, else in the first
/// that is free of what is kept, else in the first.
std::vector<PlacedToast> placeFreely(const Theme& theme, const ToastStyle& style,
                                     const std::vector<Toast*>& shown, const std::vector<StackPlace>& places,
                                     const MessageRoom& room, std::size_t& at) {
  at = std::min(at, places.size() - 1);
  for (const int spared : {2, 1, 0}) {
    for (std::size_t tried = 0; tried <= places.size(); ++tried) {
      const std::size_t index = tried == 0 ? at : tried - 1;
      std::vector<PlacedToast> placed = placeToasts(theme, style, shown, places[index]);
      const bool isShort =
          std::ranges::none_of(placed, [](const PlacedToast& toast) { return toast.place.isLong; });
      const auto spares = [&](const std::vector<Rect>& boxes) {
        return isFree(placed, places[index].room, boxes);
      };
      if (spares(room.kept) && (spared < 1 || (isShort && spares(room.spared))) &&
          (spared < 2 || spares(room.labels))) {
        at = index;
        return placed;
      }
    }
  }
  at = 0;
  return placeToasts(theme, style, shown, places.front());
}

/// Draws a message and takes its seconds, which wait while the mouse is on a long one.
void showToast(PanelContext& context, const ToastStyle& style, const PlacedToast& toast, bool canBeRead,
               ImDrawList& list) {
  drawToast(context.theme, style, *toast.message, toast.place, list);
  const bool isRead = canBeRead && toast.place.isLong && toast.place.box.contains(ImGui::GetMousePos());
  toast.message->secondsLeft -= isRead ? 0.0F : ImGui::GetIO().DeltaTime;
}

} // namespace

std::vector<DrawnToast> drawMessages(PanelContext& context, const MessageRoom& room, std::size_t& place,
                                     ImDrawList& under) {
  const Theme& theme = context.theme;
  const ImGuiWindow* const dialog = ImGui::GetTopMostPopupModal();
  const bool isAnyOpen = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (isAnyOpen && dialog == nullptr) {
    hideNews(context.ui);
  }
  std::vector<Toast*> shown;
  for (Toast& message : context.ui.toasts) {
    const bool isNews = message.kind == ToastKind::info || message.kind == ToastKind::success;
    if (dialog == nullptr || !isNews) { // News are told when the dialog is closed.
      shown.push_back(&message);
    }
  }
  const Rect dialogBox = dialog != nullptr ? Rect{dialog->Rect().Min, dialog->Rect().Max} : Rect{};
  const std::vector<StackPlace> places =
      dialog != nullptr ? placesByDialog(room.picture, dialogBox) : placesInPicture(theme, room);
  const MessageRoom placed = dialog != nullptr ? MessageRoom{room.picture, {}, {dialogBox}, {}, {}} : room;
  const ToastStyle style = toastStyle(theme, room.picture);
  ImDrawList& list = dialog != nullptr ? *ImGui::GetForegroundDrawList() : under;
  std::vector<DrawnToast> drawn;
  for (const PlacedToast& toast : placeFreely(theme, style, shown, places, placed, place)) {
    showToast(context, style, toast, dialog == nullptr, list);
    context.items.add("toast/" + std::to_string(drawn.size()), toast.place.box.min, toast.place.box.max);
    context.items.items.back().explained = true; // By itself.
    drawn.push_back({toast.place.box, toast.message->text});
  }
  std::erase_if(context.ui.toasts, [](const Toast& toast) { return toast.secondsLeft <= 0.0F; });
  return drawn;
}

} // namespace stretch::ui

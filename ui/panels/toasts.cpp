#include <algorithm>
#include <cfloat>
#include <cmath>

#include <imgui_internal.h>

#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/widgets/icons.h"

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

/// Where a message stands and how its text runs.
struct ToastPlace {
  Rect box;
  float textLeft = 0.0F;
  float wrap = 0.0F;
};

/// In the middle of the picture's width, with its upper edge at `top`.
ToastPlace placeToast(const Theme& theme, ImFont& font, const Rect& picture, const Toast& message,
                      float top) {
  const float iconColumn = theme.fonts.hasIcons ? theme.px(26.0F) : 0.0F;
  const float frame = iconColumn + theme.px(28.0F);
  const float room = picture.width() - frame - 2.0F * theme.unit();
  const float wrap = std::clamp(room, theme.px(80.0F), theme.px(420.0F));
  const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap, message.text.c_str());
  const float width = size.x + frame;
  const ImVec2 corner(std::floor(picture.centre().x - 0.5F * width), std::floor(top));
  return {{corner, {corner.x + width, corner.y + size.y + theme.px(18.0F)}},
          corner.x + theme.px(14.0F) + iconColumn,
          wrap};
}

void drawToast(const Theme& theme, ImFont& font, const Toast& message, const ToastPlace& place,
               ImDrawList& list) {
  const Rect& box = place.box;
  const float opacity = std::clamp(message.secondsLeft / fadeSeconds, 0.0F, 1.0F);
  const float shadow = theme.px(2.0F);
  list.AddRectFilled({box.min.x - shadow, box.min.y}, {box.max.x + shadow, box.max.y + shadow * 2.0F},
                     faded(theme.colours.shadow, opacity * 0.6F), theme.px(8.0F));
  list.AddRectFilled(box.min, box.max, faded(theme.colours.raised, opacity), theme.px(6.0F));
  list.AddRect(box.min, box.max, faded(theme.colours.border, opacity), theme.px(6.0F));
  const ImU32 colour = faded(toastColour(theme.colours, message.kind), opacity);
  const float y = box.min.y + theme.px(9.0F);
  if (theme.fonts.hasIcons) {
    list.AddText(&font, font.FontSize, {box.min.x + theme.px(14.0F), y}, colour, toastIcon(message.kind));
  } else {
    list.AddRectFilled(box.min, {box.min.x + theme.px(4.0F), box.max.y}, colour, theme.px(6.0F),
                       ImDrawFlags_RoundCornersLeft);
  }
  list.AddText(&font, font.FontSize, {place.textLeft, y}, faded(theme.colours.text, opacity),
               message.text.c_str(), nullptr, place.wrap);
}

} // namespace

void drawToasts(PanelContext& context, const Rect& picture, ImDrawList& under) {
  const Theme& theme = context.theme;
  const bool isDialogOpen = ImGui::GetTopMostPopupModal() != nullptr;
  const bool isAnyOpen = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (isAnyOpen && !isDialogOpen) {
    hideNews(context.ui);
  }
  ImFont& font = theme.fonts.body != nullptr ? *theme.fonts.body : *ImGui::GetFont();
  ImDrawList& list = isDialogOpen ? *ImGui::GetForegroundDrawList() : under;
  float top = picture.min.y + theme.unit();
  int count = 0;
  for (Toast& message : context.ui.toasts) {
    const bool isNews = message.kind == ToastKind::info || message.kind == ToastKind::success;
    if (isDialogOpen && isNews) {
      continue; // Told when the dialog is closed.
    }
    const ToastPlace place = placeToast(theme, font, picture, message, top);
    if (count > 0 && place.box.max.y > picture.max.y) {
      break; // Told when there is room.
    }
    drawToast(theme, font, message, place, list);
    context.items.add("toast/" + std::to_string(count++), place.box.min, place.box.max);
    context.items.items.back().explained = true; // By itself.
    message.secondsLeft -= ImGui::GetIO().DeltaTime;
    top = place.box.max.y + theme.unit();
  }
  std::erase_if(context.ui.toasts, [](const Toast& toast) { return toast.secondsLeft <= 0.0F; });
}

} // namespace stretch::ui

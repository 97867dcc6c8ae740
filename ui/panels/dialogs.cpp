#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "ui/panels/context_menu.h"
#include "ui/panels/dialog_frame.h"
#include "ui/panels/panels.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void titleRow(PanelContext& context, const DialogSpec& spec, bool& open) {
  const float side = context.theme.rowHeight();
  panelTitle(widgetsOf(context), spec.icon, spec.title, spec.closable ? side + context.theme.unit() : 0.0F);
  if (!spec.closable) {
    return;
  }
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side);
  ButtonSpec close{.id = spec.id + "/close",
                   .icon = icon::close,
                   .help = {"Close", "", "Esc"},
                   .emphasis = Emphasis::quiet,
                   .width = side,
                   .fallback = "x"};
  open = open && !button(widgetsOf(context), close);
}

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

/// Draws one message with its lower edge at `bottom`; answers its upper edge.
float drawToast(const PanelContext& context, const Toast& message, float bottom) {
  const Theme& theme = context.theme;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImFont* font = theme.fonts.body != nullptr ? theme.fonts.body : ImGui::GetFont();
  const float wrap = theme.px(420.0F);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap, message.text.c_str());
  const float iconColumn = theme.fonts.hasIcons ? theme.px(26.0F) : 0.0F;
  const ImVec2 extent(size.x + iconColumn + theme.px(28.0F), size.y + theme.px(18.0F));
  const ImVec2 corner(std::floor((screen.x - extent.x) * 0.5F), std::floor(bottom - extent.y));
  const float opacity = std::clamp(message.secondsLeft / 0.4F, 0.0F, 1.0F);
  ImDrawList* list = ImGui::GetForegroundDrawList();
  const ImVec2 end(corner.x + extent.x, corner.y + extent.y);
  const float shadow = theme.px(2.0F);
  list->AddRectFilled({corner.x - shadow, corner.y}, {end.x + shadow, end.y + shadow * 2.0F},
                      faded(theme.colours.shadow, opacity * 0.6F), theme.px(8.0F));
  list->AddRectFilled(corner, end, faded(theme.colours.raised, opacity), theme.px(6.0F));
  list->AddRect(corner, end, faded(theme.colours.border, opacity), theme.px(6.0F));
  const ImU32 colour = faded(toastColour(theme.colours, message.kind), opacity);
  const float y = corner.y + theme.px(9.0F);
  if (theme.fonts.hasIcons) {
    list->AddText(font, font->FontSize, {corner.x + theme.px(14.0F), y}, colour, toastIcon(message.kind));
  } else {
    list->AddRectFilled(corner, {corner.x + theme.px(4.0F), end.y}, colour, theme.px(6.0F),
                        ImDrawFlags_RoundCornersLeft);
  }
  list->AddText(font, font->FontSize, {corner.x + theme.px(14.0F) + iconColumn, y},
                faded(theme.colours.text, opacity), message.text.c_str(), nullptr, wrap);
  return corner.y - theme.unit();
}

} // namespace

bool beginDialog(PanelContext& context, const DialogSpec& spec, bool& open) {
  const std::string name = "##" + spec.id;
  if (!open) {
    return false;
  }
  if (!ImGui::IsPopupOpen(name.c_str())) {
    ImGui::OpenPopup(name.c_str());
  }
  const Theme& theme = context.theme;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(theme.px(spec.width), screen.x - theme.px(32.0F));
  const float height = std::min(theme.px(spec.height), screen.y - theme.px(32.0F));
  ImGui::SetNextWindowPos({std::floor(screen.x * 0.5F), std::floor(screen.y * 0.46F)}, ImGuiCond_Always,
                          {0.5F, 0.5F});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(16.0F), theme.px(12.0F)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8.0F));
  ImGui::PushStyleColor(ImGuiCol_PopupBg, theme.colours.panel);
  const bool visible = ImGui::BeginPopupModal(name.c_str(), nullptr,
                                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (!visible) {
    return false;
  }
  titleRow(context, spec, open);
  if (spec.closable && keyPressed(ImGuiKey_Escape)) {
    open = false;
  }
  if (!open) {
    ImGui::CloseCurrentPopup();
  }
  return true;
}

void endDialog() {
  ImGui::EndPopup();
}

bool keyPressed(int imguiKey, bool repeat) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(imguiKey), repeat);
}

void moveHighlight(int& highlighted, int count) {
  if (keyPressed(ImGuiKey_DownArrow, true)) {
    ++highlighted;
  }
  if (keyPressed(ImGuiKey_UpArrow, true)) {
    --highlighted;
  }
  highlighted = std::clamp(highlighted, 0, std::max(0, count - 1));
}

int dialogButtons(PanelContext& context, const std::string& id, const std::vector<ButtonSpec>& buttons) {
  const WidgetContext widgets = widgetsOf(context);
  verticalSpace(widgets, 8.0F);
  const float width = context.theme.px(116.0F);
  const float gap = context.theme.unit();
  const auto count = static_cast<float>(buttons.size());
  const float total = width * count + gap * (count - 1.0F);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, ImGui::GetContentRegionAvail().x - total));
  int clicked = -1;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (i > 0) {
      ImGui::SameLine(0.0F, gap);
    }
    ButtonSpec spec = buttons[i];
    spec.id = id + "/" + spec.text;
    spec.width = width;
    if (i + 1 == buttons.size() && spec.enabled) {
      spec.emphasis = Emphasis::primary;
    }
    clicked = button(widgets, spec) ? static_cast<int>(i) : clicked;
  }
  return clicked;
}

void drawToasts(PanelContext& context) {
  std::vector<Toast>& toasts = context.ui.toasts;
  float bottom = ImGui::GetIO().DisplaySize.y - context.theme.px(48.0F);
  // Over an open menu or dialog only what went wrong is told; the rest waits.
  const bool isCovered = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  for (Toast& message : toasts) {
    if (isCovered && (message.kind == ToastKind::info || message.kind == ToastKind::success)) {
      continue;
    }
    bottom = drawToast(context, message, bottom);
    message.secondsLeft -= ImGui::GetIO().DeltaTime;
  }
  toasts.erase(
      std::remove_if(toasts.begin(), toasts.end(), [](const Toast& t) { return t.secondsLeft <= 0.0F; }),
      toasts.end());
}

void drawDialogs(PanelContext& context) {
  drawFileDialog(context);
  drawJointDialog(context);
  drawSettingsDialog(context);
  drawKeysOverview(context);
  drawRenameDialog(context);
  drawHistoryDialog(context);
  drawContextMenu(context);
  drawQuestions(context);
  drawCommandPalette(context);
  drawToasts(context);
}

} // namespace stretch::ui

#include <algorithm>
#include <cmath>

#include <imgui.h>

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
}

} // namespace stretch::ui

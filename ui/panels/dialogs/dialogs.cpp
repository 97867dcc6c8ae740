#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/key_bar.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/menus/context_menu.h"
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

/// No tooltip before the mouse has moved since the dialog opened: it would cover what is asked.
void keepTooltipsBack() {
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const ImGuiID moved = ImGui::GetID("mouse-moved");
  const ImGuiID x = ImGui::GetID("mouse-x");
  const ImGuiID y = ImGui::GetID("mouse-y");
  const ImVec2 mouse = ImGui::GetMousePos();
  const ImVec2 before(kept.GetFloat(x), kept.GetFloat(y));
  if (ImGui::IsWindowAppearing()) {
    kept.SetBool(moved, false);
  } else if (!kept.GetBool(moved) && ImGui::IsMousePosValid(&before) &&
             (mouse.x != before.x || mouse.y != before.y)) {
    kept.SetBool(moved, true);
    ImGui::GetCurrentContext()->HoveredIdTimer = 0.0F; // Of the widget that the mouse has rested on.
  }
  kept.SetFloat(x, mouse.x);
  kept.SetFloat(y, mouse.y);
  if (!kept.GetBool(moved)) {
    hideTooltip();
  }
}

// A dialog that is as high as its content remembers from frame to frame how high that is and what stands
// below it. Where both have no room in the window the content scrolls, in a part of its own, and the buttons
// stay.

struct DialogParts {
  ImGuiID contentTop = ImGui::GetID("content-top");
  ImGuiID contentHeight = ImGui::GetID("content-height");
  ImGuiID buttonsTop = ImGui::GetID("buttons-top"); ///< -1 before the content has ended.
  ImGuiID buttonsHeight = ImGui::GetID("buttons-height");
};

/// Of the window, above and below a dialog together.
float dialogMargin(const Theme& theme) {
  return theme.px(32.0F);
}

float dialogPadding(const Theme& theme) {
  return theme.px(12.0F);
}

void beginContent(const Theme& theme) {
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const DialogParts parts;
  const float top = ImGui::GetCursorPosY();
  kept.SetFloat(parts.contentTop, top);
  const float room = ImGui::GetIO().DisplaySize.y - dialogMargin(theme) - dialogPadding(theme) - top -
                     kept.GetFloat(parts.buttonsHeight);
  if (kept.GetFloat(parts.contentHeight) > room) {
    ImGui::BeginChild("content", {0.0F, std::max(room, theme.rowHeight())});
  }
}

/// Whether the content scrolls and has not ended.
bool isInScrollingContent() {
  return (ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_ChildWindow) != 0;
}

void endContent() {
  const bool scrolls = isInScrollingContent();
  float height = 0.0F;
  if (scrolls) {
    const ImGuiWindowTempData& layout = ImGui::GetCurrentWindow()->DC;
    height = layout.CursorPos.y - layout.CursorStartPos.y;
    ImGui::EndChild();
  }
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const DialogParts parts;
  const float bottom = ImGui::GetCursorPosY();
  kept.SetFloat(parts.contentHeight, scrolls ? height : bottom - kept.GetFloat(parts.contentTop));
  kept.SetFloat(parts.buttonsTop, bottom);
}

/// How high a dialog was drawn last; 0 before.
float shownHeight(const std::string& name) {
  const ImGuiWindow* const window = ImGui::FindWindowByName(name.c_str());
  return window == nullptr ? 0.0F : window->SizeFull.y;
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
  ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg].w = spec.darkens ? behindDialogs : 0.0F;
  const Theme& theme = context.theme;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = dialogMargin(theme);
  const float width = std::min(theme.px(spec.width), screen.x - margin);
  const float height = std::min(theme.px(spec.height), screen.y - margin);
  const float lowestMiddle = std::ceil(0.5F * (margin + std::max(height, shownHeight(name))));
  const float middle =
      std::clamp(screen.x * spec.across, 0.5F * (width + margin), screen.x - 0.5F * (width + margin));
  ImGui::SetNextWindowPos({std::floor(middle), std::max(std::floor(screen.y * 0.46F), lowestMiddle)},
                          ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(16.0F), dialogPadding(theme)));
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
  keepTooltipsBack();
  titleRow(context, spec, open);
  if (spec.closable && keyPressed(ImGuiKey_Escape)) {
    open = false;
  }
  if (!open) {
    ImGui::CloseCurrentPopup();
  }
  ImGui::GetStateStorage()->SetFloat(DialogParts().buttonsTop, -1.0F);
  if (spec.height == 0.0F) {
    beginContent(theme);
  }
  return true;
}

void endDialog() {
  if (isInScrollingContent() || ImGui::GetStateStorage()->GetFloat(DialogParts().buttonsTop) < 0.0F) {
    endContent();
  }
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const DialogParts parts;
  kept.SetFloat(parts.buttonsHeight, ImGui::GetCursorPosY() - kept.GetFloat(parts.buttonsTop));
  ImGui::EndPopup();
}

bool keyPressed(int imguiKey, bool repeat) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(imguiKey), repeat);
}

bool enterPressed() {
  return keyPressed(ImGuiKey_Enter) || keyPressed(ImGuiKey_KeyPadEnter);
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
  endContent();
  verticalSpace(widgets, 8.0F);
  const float gap = context.theme.unit();
  const float room = ImGui::GetContentRegionAvail().x;
  const auto count = static_cast<float>(buttons.size());
  const float gaps = gap * (count - 1.0F);
  const float width = std::min(context.theme.px(116.0F), std::floor((room - gaps) / count));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width * count - gaps);
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
  drawClipDialog(context);
  drawClipStyleDialog(context);
  drawPoseLibraryDialog(context);
  drawReferenceDialog(context);
  drawRetimeDialog(context);
  drawHistoryDialog(context);
  drawContextMenu(context);
  drawQuestions(context);
  drawCommandPalette(context);
}

} // namespace stretch::ui

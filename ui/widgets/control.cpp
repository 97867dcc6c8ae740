#include "ui/widgets/control.h"

#include <algorithm>
#include <cstdint>

#include <imgui_internal.h>

namespace stretch::ui {

namespace {

constexpr float tooltipDelaySeconds = 0.45F;

ImFont* orDefault(ImFont* font) {
  return font != nullptr ? font : ImGui::GetFont();
}

Rect clipped(const Rect& box) {
  const ImRect clip = ImGui::GetCurrentWindow()->ClipRect;
  return {{std::max(box.min.x, clip.Min.x), std::max(box.min.y, clip.Min.y)},
          {std::min(box.max.x, clip.Max.x), std::min(box.max.y, clip.Max.y)}};
}

void tooltipHeader(const WidgetContext& context, const Help& help) {
  const ThemeColours& colours = context.theme.colours;
  if (!help.title.empty()) {
    ImGui::TextUnformatted(help.title.c_str());
  }
  if (help.keyText.empty()) {
    return;
  }
  if (!help.title.empty()) {
    ImGui::SameLine(0.0F, context.theme.px(12.0F));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, colours.accent);
  ImGui::TextUnformatted(help.keyText.c_str());
  ImGui::PopStyleColor();
}

ImVec2 tooltipPadding(const Theme& theme) {
  return {theme.px(10.0F), theme.px(8.0F)};
}

float tooltipLineGap(const Theme& theme) {
  return theme.px(4.0F);
}

float tooltipTextWidth(const Theme& theme) {
  return theme.px(300.0F);
}

/// As large as tooltipNow makes it.
ImVec2 tooltipSize(const WidgetContext& context, const Help& help) {
  const Theme& theme = context.theme;
  ImFont* font = orDefault(theme.fonts.label);
  const ImVec2 title = textSize(font, help.title);
  const ImVec2 key = textSize(font, help.keyText);
  const ImVec2 text =
      font->CalcTextSizeA(font->FontSize, FLT_MAX, tooltipTextWidth(theme), help.text.c_str());
  const float between = title.x > 0.0F && key.x > 0.0F ? theme.px(12.0F) : 0.0F;
  const float header = title.x > 0.0F || key.x > 0.0F ? font->FontSize : 0.0F;
  const float gap = header > 0.0F && !help.text.empty() ? tooltipLineGap(theme) : 0.0F;
  const ImVec2 padding = tooltipPadding(theme);
  const float slack = theme.px(4.0F); // Of whole pixels and of the words' own spacing.
  return {std::max(title.x + between + key.x, help.text.empty() ? 0.0F : text.x) + 2.0F * padding.x + slack,
          header + gap + (help.text.empty() ? 0.0F : text.y) + 2.0F * padding.y};
}

} // namespace

std::string hiddenLabel(std::string_view id) {
  return "##" + std::string(id);
}

Control takePlace(const WidgetContext& context, std::string_view id, const ImVec2& size, bool enabled) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  Control control;
  control.id = window->GetID(hiddenLabel(id).c_str());
  const ImVec2 corner = window->DC.CursorPos;
  control.box = {corner, {corner.x + size.x, corner.y + size.y}};
  const ImRect box(control.box.min, control.box.max);
  ImGui::ItemSize(size, 0.0F);
  control.visible = ImGui::ItemAdd(box, control.id);
  if (!control.visible && ImGui::GetActiveID() != control.id) {
    return control;
  }
  const Rect shown = clipped(control.box);
  context.items.add(std::string(id), shown.min, shown.max, enabled);
  if (enabled) {
    control.clicked = ImGui::ButtonBehavior(box, control.id, &control.hovered, &control.held);
  } else {
    control.hovered = ImGui::ItemHoverable(box, control.id);
  }
  return control;
}

void tooltipNow(const WidgetContext& context, const Help& help) {
  const bool empty = help.title.empty() && help.text.empty() && help.keyText.empty();
  if (empty || ImGui::GetCurrentContext()->HoveredIdTimer < 0.0F) {
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, tooltipPadding(context.theme));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                      ImVec2(context.theme.px(8.0F), tooltipLineGap(context.theme)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.theme.px(6.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
  ImGui::BeginTooltip();
  ImGui::PushFont(context.theme.fonts.label);
  tooltipHeader(context, help);
  if (!help.text.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.colours.quietText);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + tooltipTextWidth(context.theme));
    ImGui::TextUnformatted(help.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  ImGui::PopFont();
  ImGui::EndTooltip();
  ImGui::PopStyleVar(4);
}

void hideTooltip() {
  // Dear ImGui counts on from here, and from 0 again on the next widget.
  constexpr float longSeconds = 1e6F;
  ImGui::GetCurrentContext()->HoveredIdTimer = -longSeconds;
}

void tooltip(const WidgetContext& context, const Help& help) {
  const bool empty = help.title.empty() && help.text.empty();
  if (!context.items.items.empty() && !empty) {
    context.items.items.back().explained = true;
  }
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
  if (empty || !hovered || g.ActiveId != 0 || g.HoveredIdTimer < tooltipDelaySeconds) {
    return;
  }
  const ImRect panel = g.CurrentWindow->RootWindow->Rect();
  const ImRect widget = g.LastItemData.Rect;
  ImGui::SetNextWindowPos(tooltipCorner({widget.Min, widget.Max}, {panel.Min, panel.Max},
                                        tooltipSize(context, help), g.IO.DisplaySize,
                                        context.theme.px(6.0F)));
  tooltipNow(context, help);
}

ImVec2 tooltipCorner(const Rect& widget, const Rect& panel, const ImVec2& size, const ImVec2& window,
                     float gap) {
  const auto into = [](float at, float extent, float room) {
    return std::floor(std::clamp(at, 0.0F, std::max(0.0F, room - extent)));
  };
  const bool upright = panel.height() > panel.width();
  const float right = panel.max.x + gap;
  const float left = panel.min.x - gap - size.x;
  if (upright && (right + size.x <= window.x || left >= 0.0F)) {
    return {std::floor(right + size.x <= window.x ? right : left), into(widget.min.y, size.y, window.y)};
  }
  const float above = widget.min.y - gap - size.y;
  return {into(widget.min.x, size.x, window.x),
          above >= 0.0F ? std::floor(above) : into(widget.max.y + gap, size.y, window.y)};
}

ImVec2 textSize(ImFont* font, std::string_view text) {
  ImFont* used = orDefault(font);
  return used->CalcTextSizeA(used->FontSize, FLT_MAX, 0.0F, text.data(), text.data() + text.size());
}

std::string cutInMiddle(ImFont* font, const std::string& text, float width) {
  constexpr const char* dots = "\xE2\x80\xA6";
  const auto isWithinLetter = [&](std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  std::string cut = text;
  for (std::size_t kept = text.size(); kept > 2 && textSize(font, cut).x > width; --kept) {
    std::size_t head = kept - kept / 2;
    std::size_t tail = text.size() - kept / 2;
    while (isWithinLetter(head)) {
      --head;
    }
    while (isWithinLetter(tail)) {
      ++tail;
    }
    cut = text.substr(0, head) + dots + text.substr(tail);
  }
  return cut;
}

void drawText(const WidgetContext& context, ImFont* font, const Rect& box, ImU32 colour,
              std::string_view text, float alignment) {
  if (text.empty() || box.width() <= 0.0F) {
    return;
  }
  const ImVec2 size = textSize(font, text);
  const float free = std::max(0.0F, box.width() - size.x);
  const ImVec2 at(std::floor(box.min.x + free * alignment),
                  std::floor(box.min.y + (box.height() - size.y) * 0.5F));
  ImGui::PushFont(orDefault(font));
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const float right = box.max.x + context.theme.px(1.0F);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, ImVec2(right, at.y + size.y), right, right,
                            text.data(), text.data() + text.size(), &size);
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

float columnWidth(int count) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  return std::floor((ImGui::GetContentRegionAvail().x - spacing * static_cast<float>(count - 1)) /
                    static_cast<float>(count));
}

ImTextureID textureOf(unsigned name) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

void drawThumbnail(const Theme& theme, ImTextureID picture, const Rect& box) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  if (picture == nullptr) {
    list->AddRectFilled(box.min, box.max, theme.colours.sunken, theme.corner());
    return;
  }
  list->AddImageRounded(picture, box.min, box.max, {0.0F, 0.0F}, {1.0F, 1.0F}, IM_COL32_WHITE,
                        theme.corner());
}

} // namespace stretch::ui

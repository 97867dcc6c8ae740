#include "ui/widgets/color_legend.h"

namespace stretch::ui {

namespace {

constexpr float width = 216.0F;
constexpr float row = 18.0F;
constexpr float bar = 10.0F;
constexpr float margin = 10.0F;

} // namespace

ImVec2 legendSize(const Theme& theme, const ColorLegend& legend) {
  const float rows = legend.detail.empty() ? 2.0F : 3.0F;
  return {theme.px(width), theme.px(2.0F * margin + bar + 4.0F + rows * row)};
}

void drawColorLegend(const WidgetContext& context, const std::string& id, const ImVec2& corner,
                     const ColorLegend& legend) {
  const Theme& theme = context.theme;
  const ImVec2 size = legendSize(theme, legend);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Rect box{corner, {corner.x + size.x, corner.y + size.y}};
  context.items.add(id, box.min, box.max);
  list->AddRectFilled(box.min, box.max, faded(theme.colours.panel, 0.85F), theme.corner());
  const Rect inner{{box.min.x + theme.px(margin), box.min.y + theme.px(margin)},
                   {box.max.x - theme.px(margin), box.max.y - theme.px(margin)}};
  float y = inner.min.y;
  const auto line = [&](const std::string& text, ImU32 colour, float alignment) {
    drawText(context, theme.fonts.label, {{inner.min.x, y}, {inner.max.x, y + theme.px(row)}}, colour, text,
             alignment);
  };
  line(legend.title, theme.colours.text, 0.0F);
  y += theme.px(row) + theme.px(2.0F);
  constexpr int pieces = 48;
  for (int i = 0; i < pieces; ++i) {
    const float left = inner.min.x + inner.width() * static_cast<float>(i) / pieces;
    const float right = inner.min.x + inner.width() * static_cast<float>(i + 1) / pieces;
    list->AddRectFilledMultiColor(
        {left, y}, {right, y + theme.px(bar)}, legend.colour(static_cast<double>(i) / pieces),
        legend.colour(static_cast<double>(i + 1) / pieces),
        legend.colour(static_cast<double>(i + 1) / pieces), legend.colour(static_cast<double>(i) / pieces));
  }
  y += theme.px(bar) + theme.px(2.0F);
  line(legend.low, theme.colours.quietText, 0.0F);
  line(legend.high, theme.colours.quietText, 1.0F);
  y += theme.px(row);
  if (!legend.detail.empty()) {
    line(legend.detail, theme.colours.quietText, 0.0F);
  }
}

} // namespace stretch::ui

#include "ui/widgets/color_legend.h"

namespace stretch::ui {

namespace {

constexpr float width = 216.0F;
constexpr float row = 18.0F;
constexpr float bar = 10.0F;
constexpr float margin = 10.0F;
constexpr float rowWidth = 120.0F;
constexpr float rowMargin = 4.0F;
constexpr float valueWidth = 40.0F;

Rect drawGround(const WidgetContext& context, const std::string& id, const ImVec2& corner,
                const ImVec2& size) {
  const Rect box{corner, {corner.x + size.x, corner.y + size.y}};
  context.items.add(id, box.min, box.max);
  ImGui::GetWindowDrawList()->AddRectFilled(box.min, box.max, faded(context.theme.colours.panel, 0.85F),
                                            context.theme.corner());
  return box;
}

void drawBar(const Rect& box, const ColorLegend& legend) {
  constexpr int pieces = 48;
  for (int i = 0; i < pieces; ++i) {
    const float left = box.min.x + box.width() * static_cast<float>(i) / pieces;
    const float right = box.min.x + box.width() * static_cast<float>(i + 1) / pieces;
    const ImU32 from = legend.colour(static_cast<double>(i) / pieces);
    const ImU32 to = legend.colour(static_cast<double>(i + 1) / pieces);
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor({left, box.min.y}, {right, box.max.y}, from, to, to,
                                                        from);
  }
}

} // namespace

ImVec2 legendSize(const Theme& theme, const ColorLegend& legend) {
  const float rows = legend.detail.empty() ? 2.0F : 3.0F;
  return {theme.px(width), theme.px(2.0F * margin + bar + 4.0F + rows * row)};
}

void drawColorLegend(const WidgetContext& context, const std::string& id, const ImVec2& corner,
                     const ColorLegend& legend) {
  const Theme& theme = context.theme;
  const ImVec2 size = legendSize(theme, legend);
  const Rect box = drawGround(context, id, corner, size);
  const Rect inner{{box.min.x + theme.px(margin), box.min.y + theme.px(margin)},
                   {box.max.x - theme.px(margin), box.max.y - theme.px(margin)}};
  float y = inner.min.y;
  const auto line = [&](const std::string& text, ImU32 colour, float alignment) {
    drawText(context, theme.fonts.label, {{inner.min.x, y}, {inner.max.x, y + theme.px(row)}}, colour, text,
             alignment);
  };
  line(legend.title, theme.colours.text, 0.0F);
  y += theme.px(row) + theme.px(2.0F);
  drawBar({{inner.min.x, y}, {inner.max.x, y + theme.px(bar)}}, legend);
  y += theme.px(bar) + theme.px(2.0F);
  line(legend.low, theme.colours.quietText, 0.0F);
  line(legend.high, theme.colours.quietText, 1.0F);
  y += theme.px(row);
  if (!legend.detail.empty()) {
    line(legend.detail, theme.colours.quietText, 0.0F);
  }
}

ImVec2 legendRowSize(const Theme& theme) {
  return {theme.px(rowWidth), theme.px(row + 2.0F * rowMargin)};
}

void drawLegendRow(const WidgetContext& context, const std::string& id, const ImVec2& corner,
                   const ColorLegend& legend) {
  const Theme& theme = context.theme;
  const Rect box = drawGround(context, id, corner, legendRowSize(theme));
  const Rect values{{box.min.x + theme.px(2.0F * rowMargin), box.min.y},
                    {box.max.x - theme.px(2.0F * rowMargin), box.max.y}};
  drawText(context, theme.fonts.label, values, theme.colours.text, legend.low, 0.0F);
  drawText(context, theme.fonts.label, values, theme.colours.text, legend.high, 1.0F);
  const float middle = 0.5F * (box.min.y + box.max.y);
  const float half = 0.5F * theme.px(bar);
  drawBar(
      {{box.min.x + theme.px(valueWidth), middle - half}, {box.max.x - theme.px(valueWidth), middle + half}},
      legend);
}

} // namespace stretch::ui

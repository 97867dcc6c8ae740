#pragma once

#include <functional>
#include <string>

#include "ui/widgets/control.h"

namespace stretch::ui {

/// Legend of colours on a surface.
struct ColorLegend {
  std::string title;                   ///< "Error"
  std::string low;                     ///< At the left end, with the unit.
  std::string high;                    ///< At the right end.
  std::string detail = {};             ///< A further quiet line; may be empty.
  std::function<ImU32(double)> colour; ///< Colour of a share 0..1.
};

/// Screen pixels that the legend takes.
[[nodiscard]] ImVec2 legendSize(const Theme& theme, const ColorLegend& legend);

/// A bar of colours with its values on a quiet ground, its top left corner at `corner`.
void drawColorLegend(const WidgetContext& context, const std::string& id, const ImVec2& corner,
                     const ColorLegend& legend);

/// Returns the size in one row where there is little room: the bar between its values.
[[nodiscard]] ImVec2 legendRowSize(const Theme& theme);
void drawLegendRow(const WidgetContext& context, const std::string& id, const ImVec2& corner,
                   const ColorLegend& legend);

} // namespace stretch::ui

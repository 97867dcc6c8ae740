#pragma once

#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/item_registry.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

/// Context that every widget is given. Widgets draw at ImGui's cursor of the current window and keep no state
/// of their own.
struct WidgetContext {
  const Theme& theme;
  ItemRegistry& items;
};

/// Effect of one frame on a value that is edited by a gesture: a click, a drag, or typing.
struct EditPhase {
  bool changed = false; ///< The value is new.
  bool ended = false;   ///< The gesture is over.
  bool cut = false;     ///< A limit stands for what was typed.
};

/// Text of a widget's tooltip.
struct Help {
  std::string title = {};
  std::string text = {};
  std::string keyText = {};
};

struct Rect {
  ImVec2 min;
  ImVec2 max;

  [[nodiscard]] float width() const { return max.x - min.x; }
  [[nodiscard]] float height() const { return max.y - min.y; }
  [[nodiscard]] ImVec2 centre() const { return {(min.x + max.x) * 0.5F, (min.y + max.y) * 0.5F}; }
  [[nodiscard]] bool contains(const ImVec2& point) const {
    return point.x >= min.x && point.x < max.x && point.y >= min.y && point.y < max.y;
  }
  [[nodiscard]] bool overlaps(const Rect& other) const {
    return min.x < other.max.x && other.min.x < max.x && min.y < other.max.y && other.min.y < max.y;
  }
};

/// A widget's place and what the mouse does with it in this frame.
struct Control {
  unsigned id = 0;
  Rect box;
  bool visible = false;
  bool hovered = false;
  bool held = false;
  bool clicked = false; ///< Pressed and released on it.
};

/// Takes the place of a widget, records it, and answers what the mouse does with it. `id` as Item::id.
[[nodiscard]] Control takePlace(const WidgetContext& context, std::string_view id, const ImVec2& size,
                                bool enabled = true);

/// The label that ImGui knows a widget by: not shown.
[[nodiscard]] std::string hiddenLabel(std::string_view id);

/// Shows a tooltip for the last widget once the mouse has rested on it, where tooltipCorner says.
void tooltip(const WidgetContext& context, const Help& help);
/// Draws a tooltip at the mouse, for anything that says itself that it is hovered; shown at once.
void tooltipNow(const WidgetContext& context, const Help& help);
/// Hides the tooltip that stands, or would come, until the mouse rests on another widget: a key was pressed.
void hideTooltip();

/// Returns where a tooltip of a widget goes, so that it covers neither the widget nor the rows below: beside
/// an upright panel, level with the widget; above the widget in a flat one; below it only where nothing else
/// is left. Inside of the window. All of them in window units.
[[nodiscard]] ImVec2 tooltipCorner(const Rect& widget, const Rect& panel, const ImVec2& size,
                                   const ImVec2& window, float gap);

/// Text with its vertical centre in the box, cut with an ellipsis where it does not fit.
void drawText(const WidgetContext& context, ImFont* font, const Rect& box, ImU32 colour,
              std::string_view text, float alignment = 0.0F);
/// The text cut in its middle where it is wider: names of files and clips differ at their ends.
[[nodiscard]] std::string cutInMiddle(ImFont* font, const std::string& text, float width);
[[nodiscard]] ImVec2 textSize(ImFont* font, std::string_view text);

/// Width of one column of `count` that share the available width with the style's spacing.
[[nodiscard]] float columnWidth(int count);

/// A texture of OpenGL as Dear ImGui names it; null for 0, which is none.
[[nodiscard]] ImTextureID textureOf(unsigned name);

/// Draws a picture with rounded corners, or its empty place where there is none.
void drawThumbnail(const Theme& theme, ImTextureID picture, const Rect& box);

} // namespace stretch::ui

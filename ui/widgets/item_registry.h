#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace stretch::ui {

/// A widget as it stands on the screen.
struct Item {
  std::string id; ///< "trail/scale": panel and control, the same at every start.
  ImVec2 min;     ///< Screen pixels, top left.
  ImVec2 max;     ///< Screen pixels, bottom right; clipped to what is visible.
  bool enabled = true;
  bool explained = false; ///< It has a tooltip.

  [[nodiscard]] ImVec2 centre() const { return {(min.x + max.x) * 0.5F, (min.y + max.y) * 0.5F}; }
};

/// Places of all widgets of the current frame. Whoever drives the program without a hand (tests, guides)
/// looks widgets up here instead of knowing pixels.
struct ItemRegistry {
  std::vector<Item> items;

  void clear() { items.clear(); }
  void add(std::string id, const ImVec2& min, const ImVec2& max, bool enabled = true);
  /// Null when no such widget was drawn in this frame.
  [[nodiscard]] const Item* find(std::string_view id) const;
};

} // namespace stretch::ui

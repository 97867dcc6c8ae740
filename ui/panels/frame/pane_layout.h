#pragma once

#include "ui/panels/context/panel_context.h"
#include "ui/panels/state/time_state.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

/// Sizes of the panes in design pixels, and which are folded away: remembered between starts.
struct PaneSizes {
  float left = 264.0F;
  float right = 320.0F;
  float bottom = 192.0F;
  float graph = 0.0F; ///< Height of the bottom pane while it shows the graph; 0: a third of the window, no
                      ///< less than `bottom`.
  bool leftOpen = true;
  bool rightOpen = true;
  bool bottomOpen = true;

  friend bool operator==(const PaneSizes&, const PaneSizes&) = default;
};

/// Places of the panes, in window units.
struct PaneRects {
  Rect menu;
  Rect left;
  Rect viewport;
  Rect right;
  Rect bottom;
  Rect status;
};

/// Least size of a pane, design pixels.
inline constexpr float smallestPane = 140.0F;
inline constexpr float smallestViewport = 240.0F;

/// Returns the sizes with `bottom` as the bottom pane shows now. The window's height is in design pixels.
[[nodiscard]] PaneSizes sizesBeside(const PaneSizes& sizes, bool graphShows, float windowHeight);

/// Whether the bottom pane shows the graph: of a character's clip, where its tab is chosen.
[[nodiscard]] bool showsGraph(const app::OpenDocument& open, BottomTab tab);

/// Divides a window. Panes shrink before the viewport becomes too small for work; a folded pane has no size.
[[nodiscard]] PaneRects dividePanes(const PaneSizes& sizes, float width, float height, float scale,
                                    float menuHeight, float statusHeight);

/// Handles between the panes: dragging changes the size of `sizes` that shows, a double click folds the pane.
/// Call outside of any window.
void drawSplitters(PanelContext& context, const PaneRects& rects, PaneSizes& sizes);

} // namespace stretch::ui

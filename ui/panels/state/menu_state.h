#pragma once

#include <optional>

namespace stretch::ui {

/// Subject of a menu at the mouse.
enum class MenuTarget { nothing, limb, trail, group, sphere, controller, hold, key, range, time, viewport };

/// Place where a menu opens that leaves uncovered what it is about, window units.
struct MenuPlace {
  float x = 0.0F;
  float top = 0.0F;    ///< Edges of its subject:
  float bottom = 0.0F; ///< the menu ends above it, or begins below it.
};

/// The menu at the mouse.
struct MenuState {
  MenuTarget asked = MenuTarget::nothing;  ///< To be opened in this frame.
  MenuTarget target = MenuTarget::nothing; ///< Subject of the menu that was opened last.
  int hold = 0;                            ///< TimelineBar::id of the hold that the menu is about.
  double frame = 0.0;                      ///< Frame where it was opened in the timeline.
  std::optional<MenuPlace> place;          ///< Else at the mouse.
};

} // namespace stretch::ui

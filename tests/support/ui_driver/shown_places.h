#pragma once

#include <string>

#include "ui/shell/shell.h"

// Where widgets stood in the last picture, for scripts to expect.

namespace stretch::test {

/// Whether every message stands inside the picture, so that none covers what is worked with; "none" without
/// any.
[[nodiscard]] std::string toastsInPicture(const ui::Shell& shell);

/// Share of the picture's height that an item has: "0.22"; "none" without it.
[[nodiscard]] std::string shareOfPicture(const ui::Shell& shell, const char* id);

/// Share of the window's height below the handle of the bottom pane: "0.37"; "none" while it is folded.
[[nodiscard]] std::string shareBelowPicture(const ui::Shell& shell);

/// Share of the window's width left of the handle of the left pane: "0.21"; "none" while it is folded.
[[nodiscard]] std::string shareLeftOfPicture(const ui::Shell& shell);

/// Whether a message covers the character, as it stood when the messages began to come.
[[nodiscard]] bool toastsCoverFigure(const ui::Shell& shell);

/// Whether the menu at the mouse lies over the middle of a bar of the timeline.
[[nodiscard]] bool menuCoversBar(const ui::Shell& shell);

/// Whether the whole menu at the mouse is in the window.
[[nodiscard]] bool menuIsInWindow(const ui::Shell& shell);

} // namespace stretch::test

#pragma once

#include <string>

#include "ui/panels/context/panel_context.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

// Parts that the rows of the list of trails share: the name over the whole width, below it what the row holds
// and its buttons.

/// Heights, screen pixels.
struct RowLines {
  float name = 0.0F;
  float whole = 0.0F;
};
[[nodiscard]] RowLines rowLines(const Theme& theme);

/// The ground of a row that starts at the cursor, where it is selected or under the mouse.
void fillRow(PanelContext& context, bool selected);

struct RowText {
  std::string id;
  std::string title;
  std::string detail;
  ImU32 colour = 0; ///< Colour of the title.
  Help help = {};
};

/// Clicks of the mouse on a row's text.
struct RowClicks {
  bool clicked = false;
  bool renames = false;  ///< A double click.
  bool asksMenu = false; ///< A right click.
};

/// Title and detail at the cursor, up to the row's right end but for `buttons` buttons, which follow at the
/// cursor.
[[nodiscard]] RowClicks rowText(PanelContext& context, const RowText& row, int buttons);

/// One of the buttons at the end of a row's second line; the next follows on the same line.
[[nodiscard]] bool rowButton(PanelContext& context, const std::string& id, const char* iconText,
                             const char* fallback, bool on, const Help& help);

} // namespace stretch::ui

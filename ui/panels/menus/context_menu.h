#pragma once

#include <optional>
#include <string>

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// One command as an entry of a menu: its label, key, mark and tooltip; the item is `prefix` and its id. True
/// when it was chosen: the command was requested.
bool commandEntry(PanelContext& context, const std::string& prefix, const char* commandId);

/// Asks for the menu of what lies under the mouse, which was selected before: its commands act on the
/// selection. It opens at the mouse unless a place is given.
void askForMenu(UiState& ui, MenuTarget target, const std::optional<MenuPlace>& place = {});

/// The menu that was asked for, at the mouse: once a frame, after the panels, outside any window.
void drawContextMenu(PanelContext& context);

} // namespace stretch::ui

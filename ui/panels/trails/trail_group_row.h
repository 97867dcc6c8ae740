#pragma once

#include <vector>

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// The heading of trails that are one group: what it holds, folding, showing, taking apart, deleting. A click
/// selects all of them. False: its trails are folded away.
[[nodiscard]] bool trailGroupRow(PanelContext& context, const std::vector<int>& members);

} // namespace stretch::ui

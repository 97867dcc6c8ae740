#pragma once

#include "ui/panels/panel_context.h"

namespace stretch::ui {

/// What can be done with the picked keys, in one row: their frame and value as numbers, tangents, retiming.
void drawKeyBar(PanelContext& context);

void drawRetimeDialog(PanelContext& context);

} // namespace stretch::ui

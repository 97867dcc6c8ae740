#pragma once

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// Draws what can be done with the picked keys, in one row: their frame and value as numbers, tangents, and,
/// unless `keysAlone`, retiming.
void drawKeyBar(PanelContext& context, bool keysAlone);

void drawRetimeDialog(PanelContext& context);

} // namespace stretch::ui

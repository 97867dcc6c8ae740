#pragma once

#include <string>

#include "ui/panels/panel_context.h"

namespace stretch::ui {

/// Chooses the clip to work on; another clip starts at its first frame, with nothing selected in time. The
/// viewed clip must exist. Width 0: the available width.
void clipChooser(PanelContext& context, const std::string& id, float width);

} // namespace stretch::ui

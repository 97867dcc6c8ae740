#pragma once

#include <string>

#include "rig/trail/trail.h"
#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// The palette of trails in a row; a click gives the trail that colour. The items are `prefix` and the
/// number. True when one was clicked.
bool trailColours(PanelContext& context, const rig::Trail& trail, const std::string& prefix);

} // namespace stretch::ui

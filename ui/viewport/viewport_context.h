#pragma once

#include "ui/panels/context/panel_context.h"
#include "ui/viewport/tools.h"
#include "ui/viewport/viewport_state.h"

namespace stretch::ui {

/// Context of the viewport in one frame: what panels have, its own state, and the tool that runs.
struct ViewportContext : PanelContext {
  ViewportState& viewport;
  Tool& tool;
};

} // namespace stretch::ui

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

/// Whether a dialog is open that is about what is seen beside it, and nothing over that: the view is turned
/// while it stands there.
[[nodiscard]] inline bool isSeenBesideDialog(const ViewportContext& context) {
  const UiState& ui = context.ui;
  const bool isCovered =
      ui.dialogs.file.open || context.status.question.kind != app::FileQuestion::Kind::none;
  return (ui.trails.clipStyle.open || ui.body.library.open || ui.dialogs.reference.open) && !isCovered;
}

} // namespace stretch::ui

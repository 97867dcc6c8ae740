#pragma once

#include "app/schema/schema.h"
#include "app/sequence/sequence_session.h"
#include "ui/panels/state/ui_state.h"

namespace stretch::ui {

/// Settings of what the viewport draws over the character: all of it is remembered.
[[nodiscard]] const app::Schema<ViewportOverlays>& overlaySchema();

/// Settings of how a mesh sequence is shown, in the window and by `render`.
[[nodiscard]] const app::Schema<app::SequenceView>& sequenceViewSchema();

/// Theme, size, navigation and the like: what is remembered of the window's ways.
[[nodiscard]] const app::Schema<UiState>& windowSchema();

} // namespace stretch::ui

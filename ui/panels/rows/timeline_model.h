#pragma once

#include "ui/panels/context/panel_context.h"
#include "ui/widgets/timeline.h"

namespace stretch::ui {

enum class RowDetail {
  selection, ///< One row: the keys of the selected limbs, or of the whole clip.
  everyLimb  ///< A row for each limb.
};

/// Model of the session that the timeline shows; the viewed clip must exist.
[[nodiscard]] TimelineModel timelineModel(PanelContext& context, RowDetail detail);

/// The visible frames: as the user left them, else the whole clip.
[[nodiscard]] Span visibleFrames(const PanelContext& context);

/// app::shownRange as a span.
[[nodiscard]] Span shownSpan(const app::Session& session);

} // namespace stretch::ui

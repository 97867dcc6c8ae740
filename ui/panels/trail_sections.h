#pragma once

#include <string>

#include "ui/panels/panel_context.h"
#include "ui/panels/panel_support.h"

namespace stretch::ui {

// Parts of the trail settings panel. `trail` is a copy: the rows edit the document while the others are
// drawn.

void rangeRow(PanelContext& context, const rig::Trail& trail);
void scaleRows(PanelContext& context, const rig::Trail& trail); ///< Scale, style, axes, pivot.
/// What became of the tip: its length, and why it is not what was asked for.
void tipMessages(PanelContext& context, int trailId);
void releaseRows(PanelContext& context, const rig::Trail& trail);
void sphereRows(PanelContext& context, const rig::Trail& trail);
/// "Up to here and not past it": an axis-aligned plane that the limb's end does not pass.
void stopRows(PanelContext& context, const rig::Trail& trail);

/// The weight of a limb in the viewed clip: on or off, how soft, what it comes to. Edits change the same
/// setting of every selected limb that has weight.
void weightSection(PanelContext& context, const std::string& limbId);

} // namespace stretch::ui

#pragma once

#include <string>

#include "ui/panels/context/panel_context.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

// Parts of the trail settings panel. `trail` is a copy: the rows edit the document while the others are
// drawn.

void rangeRow(PanelContext& context, const rig::Trail& trail);
void scaleRows(PanelContext& context, const rig::Trail& trail); ///< Scale, style, axes, pivot.
/// What the field of styles says: the style that was taken for the trails while they are as it has them, by
/// its index, else that it was changed. Scales that were set by hand are no style, also where they pass those
/// of a cartoon.
struct ShownStyle {
  int index = -1;
  std::string otherwise = "none yet"; ///< Said while the index is -1.
};
/// Styles as a field offers them, each with its scales.
[[nodiscard]] std::vector<Choice> styleChoices(const std::vector<rig::Style>& styles);
[[nodiscard]] ShownStyle shownStyle(const TrailPanels& panels, const app::Document& document,
                                    const std::vector<int>& trails);
/// Tells what became of the tip: its length, and why it is not what was asked for.
void tipMessages(PanelContext& context, int trailId);
/// The camera that judges the trail, what it sees, and the scale as it sees it.
void sightRows(PanelContext& context, const rig::Trail& trail);
void releaseRows(PanelContext& context, const rig::Trail& trail);
void sphereRows(PanelContext& context, const rig::Trail& trail);
/// "Up to here and not past it": an axis-aligned plane that the limb's end does not pass.
void stopRows(PanelContext& context, const rig::Trail& trail);

/// The weight of a limb in the viewed clip: on or off, how soft, what it comes to. Edits change the same
/// setting of every selected limb that has weight.
void weightSection(PanelContext& context, const std::string& limbId);

/// Section of what holds hands, feet and props in the viewed clip: buttons that make a hold, and the rows of
/// each.
void holdSection(PanelContext& context);

} // namespace stretch::ui

#pragma once

#include <string>
#include <vector>

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// Time as play controls show it, of whatever is open.
struct ShownTime {
  double* frame = nullptr; ///< The playhead, to be moved.
  double last = 0.0;       ///< Frame.
  double framesPerSecond = 30.0;
};

/// The open clip's or sequence's; a viewed clip or a sequence must be there.
[[nodiscard]] ShownTime shownTime(PanelContext& context);

/// "time 1 s · range 21–27": where the playhead is, apart from what else there is to say of the time.
[[nodiscard]] std::string timeWords(double playheadSeconds, const std::vector<std::string>& others);

/// Play controls in a row: jumps, play, loop, frame, speed, clip, and a line of text about range and time.
void drawTransport(PanelContext& context);

/// Chooses the clip to work on; another clip starts at its first frame, with nothing selected in time. The
/// viewed clip must exist. Width 0: the available width.
void clipChooser(PanelContext& context, const std::string& id, float width);

} // namespace stretch::ui

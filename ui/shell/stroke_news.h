#pragma once

#include <string>

#include "app/session.h"
#include "ui/viewport/tools.h"

namespace stretch::ui {

/// What there is to say about the range that E took by itself: why these frames, that a loop's stroke goes on
/// across the seam, that the clip was marked as a loop. Empty where the stroke at the playhead was taken and
/// nothing is odd.
[[nodiscard]] std::string strokeNews(const app::Session& session, const ExaggerateTool& tool);

/// "Frames 21 to 27, stroke 2 of 4 of the left arm", after N went there.
[[nodiscard]] std::string strokeReached(const app::Session& session, const ExaggerateTool& tool);

} // namespace stretch::ui

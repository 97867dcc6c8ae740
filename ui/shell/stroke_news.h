#pragma once

#include <functional>
#include <string>

#include "app/session.h"
#include "ui/viewport/tools.h"

namespace stretch::ui {

/// Says about the range that E took by itself: why these frames, that a trail is there already and goes on,
/// that a loop's stroke goes on across the seam, that the clip was marked as a loop, and where the limb's
/// strongest stroke is if another was taken. Empty where the strongest stroke lies at the playhead and
/// nothing is odd.
[[nodiscard]] std::string strokeNews(const app::Session& session, const ExaggerateTool& tool);

/// Whether the trails that E has just made have nothing to scale: their limbs stand still in the range.
[[nodiscard]] bool standsStill(app::Session& session, const ExaggerateTool& tool);

/// Whether the trails that E has just made are of limbs that make no stroke in the clip: their greatest
/// wobble is nothing to stretch.
[[nodiscard]] bool makesNoStroke(const app::Session& session, const ExaggerateTool& tool);

/// "The left leg makes no stroke in this clip. The right arm makes the strongest stroke: 2 selects it".
/// `keyOf` answers the key of a command as it is shown, empty without one.
[[nodiscard]] std::string stillNews(app::Session& session, const ExaggerateTool& tool,
                                    const std::function<std::string(const std::string&)>& keyOf);

/// "Frames 21 to 27, stroke 2 of 4 of the left arm", after N went there.
[[nodiscard]] std::string strokeReached(const app::Session& session, const ExaggerateTool& tool);

} // namespace stretch::ui

#pragma once

#include <string>
#include <vector>

#include "app/session.h"

namespace stretch::app {

/// Says what applying these trails of the viewed clip came to: "left arm, frames 21 to 29: 12 keys"; the
/// frames are those in which the limb moves otherwise than in the source.
[[nodiscard]] std::string appliedText(Session& session, const std::vector<int>& trailIds);

/// Ids of the viewed clip's trails that the character follows and that wait to be applied.
[[nodiscard]] std::vector<int> waitingTrails(const Session& session);

} // namespace stretch::app

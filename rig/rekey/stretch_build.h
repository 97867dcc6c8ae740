#pragma once

#include <vector>

#include "rig/rekey/key_times.h"

namespace stretch::rig {

/// The stretch of one joint as keys: over the windows of all trails that stretch it, and outside them at the
/// keys of the stretch that the source has already.
[[nodiscard]] StretchKeys buildStretch(ExactMotion& exact, const std::vector<TrailKeys>& trails, int node);

} // namespace stretch::rig

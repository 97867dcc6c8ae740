#pragma once

#include <vector>

#include "rig/rekey/key_times.h"

namespace stretch::rig {

/// The stretch of one joint as keys, over the windows of the trail that stretches it.
[[nodiscard]] StretchKeys buildStretch(ExactMotion& exact, const TrailKeys& keys, int node);

} // namespace stretch::rig

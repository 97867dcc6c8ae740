#pragma once

#include "app/document.h"

namespace stretch::app {

/// The same moments in frames of a rate that is `factor` times as high.
[[nodiscard]] rig::Trail recounted(rig::Trail trail, double factor);
[[nodiscard]] WeightedLimb recounted(WeightedLimb weight, double factor);

} // namespace stretch::app

#pragma once

#include "core/math/types.h"

namespace stretch::skinning {

/// Place where a joint seems to be, in the body's own space (Upright::toBody).
struct Placed {
  Vec3 place{0.0};
  double confidence = 0.0; ///< 0..1.
};

} // namespace stretch::skinning

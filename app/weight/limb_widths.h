#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::app {

/// How long and how thick each bone of a limb is in the bind pose, world units.
struct LimbSize {
  std::vector<double> lengths; ///< One for each bone, > 0.
  std::vector<double> widths;  ///< Mean shape diameter of the surface that follows the bone, > 0; where the
                               ///< limb has no surface, a sixth of the bone's length.
};

/// `others`: all limbs of the character: what follows them does not count.
[[nodiscard]] LimbSize limbSize(const Scene& scene, const rig::Limb& limb,
                                const std::vector<rig::Limb>& others);

} // namespace stretch::app

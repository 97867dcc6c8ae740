#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/controllers/adjustment.h"
#include "rig/motion/solved_adjustments.h"

namespace stretch::rig {

/// What the adjustments of a clip are solved from.
struct AdjustmentInput {
  const Scene& scene;
  const Clip& clip;
  NodeIndex hips;
  const std::vector<Limb>& limbs;
  const std::vector<Adjustment>& adjustments; ///< Of this clip; those of missing controllers are left out.
};

[[nodiscard]] SolvedAdjustments solveAdjustments(const AdjustmentInput& input);

} // namespace stretch::rig

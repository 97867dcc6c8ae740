#pragma once

#include <memory>
#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/adjust/solved_adjustments.h"
#include "rig/controllers/adjustment.h"

namespace stretch::rig {

/// Ground that adjustments stand on.
struct AdjustmentGround {
  const Scene& scene;
  const Clip& clip;
  NodeIndex hips;
  const std::vector<Limb>& limbs;
};

[[nodiscard]] AdjustedBody adjustedBody(const AdjustmentGround& ground);

/// Input from which the adjustments of a clip are solved.
struct AdjustmentInput {
  AdjustmentGround ground;
  const std::vector<Adjustment>& adjustments; ///< Adjustments of this clip; those of missing controllers are
                                              ///< left out.
  std::shared_ptr<const AdjustedBody> body;   ///< Body on this ground; null: it is made.
};

[[nodiscard]] SolvedAdjustments solveAdjustments(const AdjustmentInput& input);

} // namespace stretch::rig

#pragma once

#include <string>
#include <vector>

#include "core/math/types.h"
#include "core/scene/scene.h"
#include "rig/adjust/solved_adjustments.h"
#include "rig/limb.h"

namespace stretch::rig {

/// Shape that a controller is drawn as (docs/controllers.md, In the viewport): measured from the character's
/// own mesh in the bind pose, else from the lengths of its limbs.
struct ControllerShape {
  std::string controller; ///< Controller::id.
  /// Each a run of points, closed where its last point is its first. From the controller's place, along the
  /// scene's axes in the bind pose, world units.
  std::vector<std::vector<Vec3>> lines;
};

/// Returns the shapes of all controllers of the body but poles, which stand elsewhere in each frame, in their
/// order.
[[nodiscard]] std::vector<ControllerShape>
controllerShapes(const Scene& scene, const std::vector<Limb>& limbs, const AdjustedBody& body);

} // namespace stretch::rig

#pragma once

#include <optional>
#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// An action to look at, world space.
struct SightedAction {
  std::vector<Vec3> path; ///< Places of the limb's end, in order of time.
  Vec3 base{0.0};         ///< The limb at its extreme.
  Vec3 tip{0.0};
  Vec3 trunkLow{0.0}; ///< The body's middle, which may be in the way.
  Vec3 trunkHigh{0.0};
  double trunkRadius = 0.0;   ///< 0: nothing is in the way.
  std::optional<Vec3> facing; ///< Direction in which the face looks at the extreme; unit.
};

/// The direction towards the eye from which the action is seen best, unit: where path and limb are longest in
/// the picture, the face is not turned away, and the trunk does not hide the path; level with it or a little
/// above (docs/exaggeration.md, As the camera sees it). Looked for in steps of 5 degrees.
[[nodiscard]] Vec3 bestView(const SightedAction& action);

} // namespace stretch::rig

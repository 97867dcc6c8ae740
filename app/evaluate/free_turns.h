#pragma once

#include <cstddef>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/math/types.h"
#include "core/scene/node_index.h"
#include "rig/limb.h"

namespace stretch::app {

/// A limb at one frame, as far as its turns count; world space.
struct TurnedLimb {
  std::vector<Vec3> points;   ///< Joints, base first, and the end.
  std::vector<Quat> joints;   ///< Rotation of each joint.
  std::vector<Quat> carriers; ///< Rotation of each node that carries the limb.
};

[[nodiscard]] TurnedLimb turnedLimb(const rig::Limb& limb, const std::vector<NodeIndex>& carriers,
                                    const FrameState& frame);

/// Angles by which one joint turns within a frame, degrees.
struct FreeTurn {
  double degrees = 0.0;
  double sourceDegrees = 0.0;

  [[nodiscard]] double excess() const { return degrees - 2.0 * sourceDegrees; }
};

/// Two frames in a row of a limb, which outlive this.
struct LimbStep {
  const TurnedLimb& before;
  const TurnedLimb& after;
};

/// Returns the worst free turn of a step of a limb: a joint turns by more than twice what it turns in the
/// source, what the offsets turn its carriers, and `allowedDegrees`, though the ends of the limb do not make
/// it, as they would where its bones turned so far even if its plane did not turn about the line from base to
/// end, or where the end is as near to the base as its bones allow (docs/controllers.md, Arms and legs). No
/// degrees: there is none.
[[nodiscard]] FreeTurn freeTurn(const LimbStep& source, const LimbStep& moved, double allowedDegrees);

} // namespace stretch::app

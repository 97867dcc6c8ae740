#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// The bend plane of a limb over a stretch of motion: the axis about which its elbow or knee bends, kept in
/// the frame of the base joint, in which it hardly moves. It stands in for the pole: where the limb is nearly
/// straight the pose itself no longer tells the plane, and the average decides, so that the bend never flips.
class BendNormal {
public:
  /// Takes in one pose: joints base first and the end, world space, and the base joint's world rotation.
  void add(const std::vector<Vec3>& points, const Quat& baseRotation);

  /// Unit normal of the bend plane in world space for a pose; zero when no pose ever showed a bend.
  [[nodiscard]] Vec3 at(const std::vector<Vec3>& points, const Quat& baseRotation) const;

private:
  Vec3 sum_{0.0}; ///< In the base joint's frame, weighted by the sine of the bend.
};

} // namespace stretch::rig

#pragma once

#include <vector>

#include "assets/dummy/pose.h"
#include "assets/dummy/skeleton.h"

namespace stretch::assets {

/// World placement of every joint.
struct SolvedPose {
  std::vector<Vec3> positions;
  std::vector<Quat> rotations; ///< Identity in the bind pose.
};

/// Trunk and arms by the pose's controls, legs by two-bone inverse kinematics, so that the balls of the feet
/// stand where the pose puts them as long as the legs reach.
[[nodiscard]] SolvedPose solvePose(const std::vector<Joint>& skeleton, const Pose& pose);

/// The same with the hips placed by the caller; the pose's own hips play no part.
[[nodiscard]] SolvedPose solvePose(const std::vector<Joint>& skeleton, const Pose& pose, const Vec3& hips,
                                   const Quat& hipsRotation);

/// World rotation of a hand whose knuckles and thumb point there.
[[nodiscard]] Quat handRotation(const std::vector<Joint>& skeleton, bool isLeft, const Vec3& knuckles,
                                const Vec3& thumb);

/// Rotation of a joint relative to its parent.
[[nodiscard]] Quat localRotation(const std::vector<Joint>& skeleton, const SolvedPose& solved, int joint);

} // namespace stretch::assets

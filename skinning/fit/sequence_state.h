#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/mesh_sequence.h"
#include "skinning/fit/fit_state.h"

// Internal to skinning/fit: from sequences and bones to the numbers of the fit, and back.

namespace stretch::skinning::fit {

/// Moves the mesh so that the bind pose's centre is the origin and its diagonal 1.
struct MeshFrame {
  Vec3 centre{0.0};
  double scale = 1.0;

  [[nodiscard]] Eigen::Vector3d in(const Vec3& p) const {
    const Vec3 q = (p - centre) / scale;
    return {q.x, q.y, q.z};
  }
  [[nodiscard]] Vec3 out(const Eigen::Vector3d& q) const {
    return centre + scale * Vec3(q.x(), q.y(), q.z());
  }
};

[[nodiscard]] MeshFrame frameOf(const std::vector<glm::vec3>& positions);

[[nodiscard]] Eigen::Matrix3d toEigen(const Quat& q);
[[nodiscard]] Quat toQuat(const Eigen::Matrix3d& rotation);

/// The stretch of a pose in the space of the mesh: symmetric.
[[nodiscard]] Eigen::Matrix3d stretchMatrix(const BonePose& pose);

/// The state over the frames from `firstFrame` on, with the bone matrices of the poses where there are any.
[[nodiscard]] FitState makeState(const MeshSequence& sequence, const SkinnedSequence& skinned,
                                 const MeshFrame& frame, std::size_t firstFrame);

/// Scales of the poses from `firstFrame` on, `count` of them; ones where there are no poses.
[[nodiscard]] std::vector<Eigen::Vector3d> scalesOf(const SkinnedSequence& skinned, std::size_t firstFrame,
                                                    std::size_t count);

/// Poses of free bones by the matrices of the state and their scales.
void writeFreePoses(const FitState& state, const std::vector<Eigen::Vector3d>& scales, const MeshFrame& frame,
                    SkinnedSequence& skinned);

/// Quaternions q and -q are one rotation: successive frames are put on one hemisphere, so that interpolation
/// goes the short way.
void alignHemispheres(SkinnedSequence& skinned);

} // namespace stretch::skinning::fit

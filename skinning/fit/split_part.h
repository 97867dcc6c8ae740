#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "skinning/fit/fit_state.h"

// Internal to skinning/fit: a part of a body that moves alike, and how it is taken in two.

namespace stretch::skinning::fit {

/// Vertices of a part, and how badly its bone follows them.
struct MotionCluster {
  std::vector<std::size_t> vertices;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< In the bind pose.
  double error = 0.0;                               ///< Squared, over vertices and frames.
};

/// For each bone the vertices that hang on it more than on others. `errors`: of all vertices.
[[nodiscard]] std::vector<MotionCluster> partsOf(const FitState& state, const std::vector<double>& errors);

/// Bones and vertices in turn, every vertex on the bone that follows it best.
void settleParts(FitState& state, int rounds);

/// A part by itself, on two bones: its vertices at `second` (indices into the part's) on the second one.
[[nodiscard]] FitState partInTwo(const FitState& state, const MotionCluster& cluster,
                                 const std::vector<std::size_t>& second);

/// Vertices of a part that go to a second bone, the better of two beginnings; empty where either would leave
/// one of the two with hardly a vertex. `errors`: of all vertices of the state.
[[nodiscard]] std::vector<std::size_t> bestHalf(const FitState& state, const MotionCluster& cluster,
                                                const std::vector<double>& errors);

} // namespace stretch::skinning::fit

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "skinning/skinned_sequence.h"

// Internal to skinning/fit: the numbers that the least-squares steps hand to each other. Positions are moved
// so that the bind pose's centre is the origin and scaled so that its box diagonal is 1.

namespace stretch::skinning::fit {

/// Row-major 3 x 4: linear part and translation.
using BoneMatrix = Eigen::Matrix<double, 3, 4>;

/// Observed positions, one column for each vertex: x of all frames, then y, then z.
using Trajectories = Eigen::MatrixXf;

struct FitState {
  std::size_t frameCount = 0;
  std::size_t boneCount = 0;
  Trajectories observed;              ///< (3 frames) x vertices.
  std::vector<Eigen::Vector3d> bind;  ///< One for each vertex.
  std::vector<Influences> influences; ///< One for each vertex.
  std::vector<BoneMatrix> matrices;   ///< Frame after frame, one for each bone.
  std::vector<Eigen::Matrix3d> axes;  ///< Of each bone: columns are the axes along which it may stretch.
  double largestScale = 10.0;         ///< And by how much, at most; at least by 1 over it.

  [[nodiscard]] BoneMatrix& matrix(std::size_t frame, std::size_t bone) {
    return matrices[frame * boneCount + bone];
  }
  [[nodiscard]] const BoneMatrix& matrix(std::size_t frame, std::size_t bone) const {
    return matrices[frame * boneCount + bone];
  }
  [[nodiscard]] std::size_t vertexCount() const { return bind.size(); }
};

/// The weights on a simplex (w >= 0, sum 1, at most `most` of them not 0) that minimise w^T G w, G symmetric
/// and positive semi-definite; a ridge of 1e-9 of its trace settles ties. The few rounds of dropping the
/// least weight are a heuristic for which of them stay, the values of those that stay are exact.
[[nodiscard]] Eigen::VectorXd simplexLeastSquares(const Eigen::MatrixXd& original, int most);

/// Fits every vertex's influences to its trajectory, bones and bind pose given: least squares over the
/// frames, at most `most` of the `candidateCount` bones that alone follow the vertex best.
void solveWeights(FitState& state, int candidateCount, int most);

} // namespace stretch::skinning::fit

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
  std::vector<Eigen::Matrix3d> axes;  ///< Axes of each bone: columns are the axes along which it may stretch.
  double largestScale = 10.0;         ///< And by how much, at most; at least by 1 over it.

  [[nodiscard]] BoneMatrix& matrix(std::size_t frame, std::size_t bone) {
    return matrices[frame * boneCount + bone];
  }
  [[nodiscard]] const BoneMatrix& matrix(std::size_t frame, std::size_t bone) const {
    return matrices[frame * boneCount + bone];
  }
  [[nodiscard]] std::size_t vertexCount() const { return bind.size(); }
};

/// Start of the search for a vertex's weights.
enum class WeightSearch {
  everywhere, ///< With all candidates, and with the bones that it hangs on: the better of both.
  own,        ///< With the bones that it hangs on, and no others: a fifth of the time.
};

/// Fits every vertex's influences to its trajectory, bones and bind pose given: least squares over the frames
/// (not negative, sum 1), at most `most` of the `candidateCount` bones that alone follow the vertex best and
/// of those that it hangs on. No vertex is followed worse than before.
void solveWeights(FitState& state, int candidateCount, int most,
                  WeightSearch from = WeightSearch::everywhere);

/// For each bone, how much larger the squared error over vertices and frames would be if the others had to
/// follow its vertices, as they move now; told by some thousand vertices.
[[nodiscard]] std::vector<double> lossesWithout(const FitState& state, int candidateCount, int most);

/// Squared distance of every vertex to where its bones put it, over all frames.
[[nodiscard]] std::vector<double> vertexErrors(const FitState& state);

} // namespace stretch::skinning::fit

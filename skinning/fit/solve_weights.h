#pragma once

#include "skinning/fit/fit_state.h"

namespace stretch::skinning::fit {

/// The weights on a simplex (w >= 0, sum 1, at most `most` of them not 0) that minimise w^T G w, G symmetric
/// and positive semi-definite; a ridge of 1e-9 of its trace settles ties. The few rounds of dropping the
/// least weight are a heuristic for which of them stay, the values of those that stay are exact.
[[nodiscard]] Eigen::VectorXd simplexLeastSquares(const Eigen::MatrixXd& original, int most);

/// Fits every vertex's influences to its trajectory, bones and bind pose given: least squares over the
/// frames, among the `candidateCount` bones that alone follow the vertex best.
void solveWeights(FitState& state, int candidateCount);

} // namespace stretch::skinning::fit

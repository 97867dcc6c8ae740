#include "skinning/fit/fit_state.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <Eigen/Cholesky>
#include <tbb/parallel_for.h>

namespace stretch::skinning::fit {
namespace {

/// Bone matrices as columns over the frames, so that a vertex's whole path under a bone is twelve multiples
/// of columns.
class BonePaths {
public:
  explicit BonePaths(const FitState& state) : frames_(static_cast<Eigen::Index>(state.frameCount)) {
    columns_.resize(frames_, static_cast<Eigen::Index>(12 * state.boneCount));
    for (std::size_t k = 0; k < state.frameCount; ++k) {
      for (std::size_t b = 0; b < state.boneCount; ++b) {
        const BoneMatrix& matrix = state.matrix(k, b);
        for (Eigen::Index row = 0; row < 3; ++row) {
          for (Eigen::Index column = 0; column < 4; ++column) {
            columns_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(12 * b) + 4 * row + column) =
                static_cast<float>(matrix(row, column));
          }
        }
      }
    }
  }

  /// Path of `point` under `bone` minus `observed`, into `out` (3 frames long).
  template <typename Observed, typename Out>
  void deviation(std::size_t bone, const Eigen::Vector3f& point, const Observed& observed, Out&& out) const {
    for (Eigen::Index row = 0; row < 3; ++row) {
      const auto first = static_cast<Eigen::Index>(12 * bone) + 4 * row;
      out.segment(row * frames_, frames_) = columns_.col(first) * point.x() +
                                            columns_.col(first + 1) * point.y() +
                                            columns_.col(first + 2) * point.z() + columns_.col(first + 3) -
                                            observed.segment(row * frames_, frames_);
    }
  }

private:
  Eigen::Index frames_;
  Eigen::MatrixXf columns_;
};

/// w = G^-1 1 / (1^T G^-1 1) over the chosen indices: the minimum of w^T G w with sum 1.
Eigen::VectorXd onPlane(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& chosen) {
  const auto count = static_cast<Eigen::Index>(chosen.size());
  Eigen::MatrixXd part(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      part(i, j) = gram(chosen[static_cast<std::size_t>(i)], chosen[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::VectorXd weights = part.ldlt().solve(Eigen::VectorXd::Ones(count));
  return weights / weights.sum();
}

/// Takes the index with the least weight out until all weights are positive and few enough.
Eigen::VectorXd shrink(const Eigen::MatrixXd& gram, std::vector<Eigen::Index>& chosen, int most) {
  Eigen::VectorXd weights = onPlane(gram, chosen);
  while (chosen.size() > 1) {
    Eigen::Index least = 0;
    const double smallest = weights.minCoeff(&least);
    if (smallest > 0.0 && chosen.size() <= static_cast<std::size_t>(most)) {
      break;
    }
    chosen.erase(chosen.begin() + least);
    weights = onPlane(gram, chosen);
  }
  return weights;
}

/// The index outside `chosen` whose weight, let grow, would lower the error most; -1 when none would.
Eigen::Index bestEntering(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& chosen,
                          const Eigen::VectorXd& weights) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(gram.rows());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    gradient += gram.col(chosen[i]) * weights(static_cast<Eigen::Index>(i));
  }
  const double level = gradient(chosen.front());
  Eigen::Index best = -1;
  double lowest = level * (1.0 - 1e-6);
  for (Eigen::Index j = 0; j < gram.rows(); ++j) {
    if (gradient(j) < lowest && std::find(chosen.begin(), chosen.end(), j) == chosen.end()) {
      best = j;
      lowest = gradient(j);
    }
  }
  return best;
}

double valueOf(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& chosen,
               const Eigen::VectorXd& weights) {
  double value = 0.0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      value += weights(static_cast<Eigen::Index>(i)) * weights(static_cast<Eigen::Index>(j)) *
               gram(chosen[i], chosen[j]);
    }
  }
  return value;
}

/// Indices of the `count` smallest diagonal entries, smallest first.
std::vector<std::size_t> smallest(const Eigen::VectorXd& errors, int count) {
  std::vector<std::size_t> order(static_cast<std::size_t>(errors.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t kept = std::min(order.size(), static_cast<std::size_t>(count));
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      const double errorA = errors(static_cast<Eigen::Index>(a));
                      const double errorB = errors(static_cast<Eigen::Index>(b));
                      return errorA < errorB || (errorA == errorB && a < b);
                    });
  order.resize(kept);
  return order;
}

Influences toInfluences(const std::vector<std::size_t>& bones, const Eigen::VectorXd& weights) {
  Influences influences;
  std::size_t slot = 0;
  for (std::size_t i = 0; i < bones.size() && slot < Influences::capacity; ++i) {
    const double weight = weights(static_cast<Eigen::Index>(i));
    if (weight > 0.0) {
      influences.bones[slot] = static_cast<std::uint16_t>(bones[i]);
      influences.weights[slot] = static_cast<float>(weight);
      ++slot;
    }
  }
  return influences;
}

Influences fitVertex(const FitState& state, const BonePaths& paths, std::size_t vertex, int candidateCount,
                     int most, Eigen::MatrixXf& deviations) {
  const Eigen::Vector3f point = state.bind[vertex].cast<float>();
  const auto observed = state.observed.col(static_cast<Eigen::Index>(vertex));
  const auto boneCount = static_cast<Eigen::Index>(state.boneCount);
  Eigen::VectorXd errors(boneCount);
  for (Eigen::Index b = 0; b < boneCount; ++b) {
    paths.deviation(static_cast<std::size_t>(b), point, observed, deviations.col(0));
    errors(b) = static_cast<double>(deviations.col(0).squaredNorm());
  }
  const std::vector<std::size_t> candidates = smallest(errors, candidateCount);
  const auto count = static_cast<Eigen::Index>(candidates.size());
  for (Eigen::Index c = 0; c < count; ++c) {
    paths.deviation(candidates[static_cast<std::size_t>(c)], point, observed, deviations.col(c));
  }
  Eigen::MatrixXd gram(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      gram(i, j) = gram(j, i) = static_cast<double>(deviations.col(i).dot(deviations.col(j)));
    }
  }
  return toInfluences(candidates, simplexLeastSquares(gram, most));
}

} // namespace

Eigen::VectorXd simplexLeastSquares(const Eigen::MatrixXd& original, int most) {
  const Eigen::Index count = original.rows();
  Eigen::MatrixXd gram = original;
  gram.diagonal().array() += 1e-9 * original.trace() + 1e-300;
  std::vector<Eigen::Index> chosen(static_cast<std::size_t>(count));
  std::iota(chosen.begin(), chosen.end(), Eigen::Index{0});
  Eigen::VectorXd weights = shrink(gram, chosen, most);
  for (Eigen::Index round = 0; round < count; ++round) {
    const Eigen::Index entering = bestEntering(gram, chosen, weights);
    if (entering < 0) {
      break;
    }
    std::vector<Eigen::Index> tried = chosen;
    tried.push_back(entering);
    const Eigen::VectorXd triedWeights = shrink(gram, tried, most);
    if (!(valueOf(gram, tried, triedWeights) < valueOf(gram, chosen, weights) * (1.0 - 1e-9))) {
      break;
    }
    chosen = tried;
    weights = triedWeights;
  }
  Eigen::VectorXd all = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    all(chosen[i]) = weights(static_cast<Eigen::Index>(i));
  }
  return all;
}

void solveWeights(FitState& state, int candidateCount, int most) {
  const BonePaths paths(state);
  const int candidates = std::min(candidateCount, static_cast<int>(state.boneCount));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, state.vertexCount(), 64), [&](const auto& range) {
    Eigen::MatrixXf deviations(static_cast<Eigen::Index>(3 * state.frameCount), candidates);
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      state.influences[v] = fitVertex(state, paths, v, candidates, most, deviations);
    }
  });
}

} // namespace stretch::skinning::fit

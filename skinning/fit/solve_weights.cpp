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

constexpr Eigen::Index mostCandidates = 24;

/// Products of the deviations under the candidates of a vertex. Bounded, since a vertex has no time to ask
/// for memory.
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostCandidates, mostCandidates>;
using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostCandidates, 1>;

/// Candidates with a weight, by their index, and the weights.
struct Support {
  std::array<Eigen::Index, mostCandidates> of{};
  Eigen::Index count = 0;
  Weights weights;

  void add(Eigen::Index candidate) { of[static_cast<std::size_t>(count++)] = candidate; }
  void remove(Eigen::Index at) {
    std::copy(of.begin() + at + 1, of.begin() + count, of.begin() + at);
    --count;
  }
  [[nodiscard]] Eigen::Index at(Eigen::Index i) const { return of[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool has(Eigen::Index candidate) const {
    return std::find(of.begin(), of.begin() + count, candidate) != of.begin() + count;
  }
};

/// w = G^-1 1 / (1^T G^-1 1) over the support: the minimum of w^T G w with sum 1.
void solveOnPlane(const Gram& gram, Support& support) {
  Gram part(support.count, support.count);
  for (Eigen::Index i = 0; i < support.count; ++i) {
    for (Eigen::Index j = 0; j < support.count; ++j) {
      part(i, j) = gram(support.at(i), support.at(j));
    }
  }
  support.weights = part.ldlt().solve(Weights::Ones(support.count));
  support.weights /= support.weights.sum();
}

/// Takes the candidate with the least weight out until all weights are positive and few enough.
void shrink(const Gram& gram, int most, Support& support) {
  solveOnPlane(gram, support);
  while (support.count > 1) {
    Eigen::Index least = 0;
    const double smallest = support.weights.minCoeff(&least);
    if (smallest > 0.0 && support.count <= most) {
      break;
    }
    support.remove(least);
    solveOnPlane(gram, support);
  }
}

/// The candidate outside whose weight, let grow, would lower the error most; -1 when none would.
Eigen::Index bestEntering(const Gram& gram, const Support& support) {
  Weights gradient = Weights::Zero(gram.rows());
  for (Eigen::Index i = 0; i < support.count; ++i) {
    gradient += gram.col(support.at(i)) * support.weights(i);
  }
  const double level = gradient(support.at(0));
  Eigen::Index best = -1;
  double lowest = level * (1.0 - 1e-6);
  for (Eigen::Index j = 0; j < gram.rows(); ++j) {
    if (gradient(j) < lowest && !support.has(j)) {
      best = j;
      lowest = gradient(j);
    }
  }
  return best;
}

double valueOf(const Gram& gram, const Support& support) {
  double value = 0.0;
  for (Eigen::Index i = 0; i < support.count; ++i) {
    for (Eigen::Index j = 0; j < support.count; ++j) {
      value += support.weights(i) * support.weights(j) * gram(support.at(i), support.at(j));
    }
  }
  return value;
}

/// The weights on a simplex (w >= 0, sum 1, at most `most` of them not 0) that minimise w^T G w, searched
/// from a support. Which of them stay is a heuristic, the values of those that stay are exact.
void searchFrom(const Gram& gram, int most, Support& support) {
  shrink(gram, most, support);
  for (Eigen::Index round = 0; round < gram.rows(); ++round) {
    const Eigen::Index entering = bestEntering(gram, support);
    if (entering < 0) {
      break;
    }
    Support tried = support;
    tried.add(entering);
    shrink(gram, most, tried);
    if (!(valueOf(gram, tried) < valueOf(gram, support) * (1.0 - 1e-9))) {
      break;
    }
    support = tried;
  }
}

/// Indices of the `count` smallest errors, smallest first.
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

Influences toInfluences(const std::vector<std::size_t>& bones, const Support& support) {
  Influences influences;
  std::size_t slot = 0;
  for (Eigen::Index i = 0; i < support.count && slot < Influences::capacity; ++i) {
    const double weight = support.weights(i);
    if (weight > 0.0) {
      influences.bones[slot] = static_cast<std::uint16_t>(bones[static_cast<std::size_t>(support.at(i))]);
      influences.weights[slot] = static_cast<float>(weight);
      ++slot;
    }
  }
  return influences;
}

/// How the weights of a vertex are searched.
struct Search {
  int candidates = 1;
  int most = 1;
  WeightSearch from = WeightSearch::everywhere;
};

/// One vertex: its candidates, the deviations under them, the best weights.
class VertexFit {
public:
  VertexFit(const FitState& state, const BonePaths& paths, const Search& search)
      : state_(state), paths_(paths), search_(search),
        deviations_(static_cast<Eigen::Index>(3 * state.frameCount), mostCandidates) {}

  Influences fit(std::size_t vertex) {
    measure(vertex);
    Support best;
    if (own_.count > 0) {
      best = own_;
      searchFrom(gram_, search_.most, best);
    }
    if (own_.count == 0 || search_.from == WeightSearch::everywhere) {
      const Support wide = widest();
      best = own_.count == 0 || valueOf(gram_, wide) < valueOf(gram_, best) ? wide : best;
    }
    return toInfluences(bones_, best);
  }

  /// Adds to each bone what the squared error of the vertex would be more without it.
  void addLosses(std::size_t vertex, double factor, std::vector<double>& losses) {
    measure(vertex);
    const Support all = widest();
    const double with = valueOf(gram_, all);
    for (Eigen::Index i = 0; i < all.count && gram_.rows() > 1; ++i) {
      Gram without = gram_; // A candidate that is far off everywhere is never taken.
      without(all.at(i), all.at(i)) += 1e6 * (gram_.trace() + 1e-300);
      Support left = all;
      left.remove(i);
      if (left.count == 0) {
        left.add(all.at(i) == 0 ? 1 : 0);
      }
      searchFrom(without, search_.most, left);
      losses[bones_[static_cast<std::size_t>(all.at(i))]] += factor * (valueOf(without, left) - with);
    }
  }

private:
  [[nodiscard]] Support widest() const {
    Support wide;
    for (Eigen::Index i = 0; i < gram_.rows(); ++i) {
      wide.add(i);
    }
    searchFrom(gram_, search_.most, wide);
    return wide;
  }

  /// Candidates are the bones that follow the vertex best alone, and those that it hangs on.
  void measure(std::size_t vertex) {
    const Eigen::Vector3f point = state_.bind[vertex].cast<float>();
    const auto observed = state_.observed.col(static_cast<Eigen::Index>(vertex));
    bones_.clear();
    if (search_.from == WeightSearch::everywhere) {
      bones_ = bestAlone(point, observed);
    }
    takeOwn(state_.influences[vertex]);
    const auto count = static_cast<Eigen::Index>(bones_.size());
    for (Eigen::Index c = 0; c < count; ++c) {
      paths_.deviation(bones_[static_cast<std::size_t>(c)], point, observed, deviations_.col(c));
    }
    gram_.resize(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        gram_(i, j) = gram_(j, i) = static_cast<double>(deviations_.col(i).dot(deviations_.col(j)));
      }
    }
    gram_.diagonal().array() += 1e-9 * gram_.trace() + 1e-300; // Settles ties.
  }

  template <typename Observed>
  std::vector<std::size_t> bestAlone(const Eigen::Vector3f& point, const Observed& observed) {
    Eigen::VectorXd errors(static_cast<Eigen::Index>(state_.boneCount));
    for (std::size_t b = 0; b < state_.boneCount; ++b) {
      paths_.deviation(b, point, observed, deviations_.col(0));
      errors(static_cast<Eigen::Index>(b)) = static_cast<double>(deviations_.col(0).squaredNorm());
    }
    return smallest(errors, search_.candidates);
  }

  void takeOwn(const Influences& influences) {
    own_ = {};
    for (std::size_t i = 0; i < Influences::capacity && search_.most > 1; ++i) {
      if (influences.weights[i] > 0.0F) {
        const auto bone = static_cast<std::size_t>(influences.bones[i]);
        auto found = std::ranges::find(bones_, bone);
        if (found == bones_.end()) {
          found = bones_.insert(bones_.end(), bone);
        }
        own_.add(found - bones_.begin());
      }
    }
  }

  const FitState& state_;
  const BonePaths& paths_;
  Search search_;
  std::vector<std::size_t> bones_; ///< The candidates.
  Support own_; ///< Those that the vertex hangs on; empty where one bone is all it may have.
  Gram gram_;
  Eigen::MatrixXf deviations_;
};

/// As many as there are, and no more than fit beside those that a vertex hangs on.
int candidatesOf(const FitState& state, int wanted) {
  constexpr int most = static_cast<int>(mostCandidates) - static_cast<int>(Influences::capacity);
  return std::min({wanted, most, static_cast<int>(state.boneCount)});
}

} // namespace

void solveWeights(FitState& state, int candidateCount, int most, WeightSearch from) {
  const BonePaths paths(state);
  const Search search{candidatesOf(state, candidateCount), most, from};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, state.vertexCount(), 64), [&](const auto& range) {
    VertexFit vertex(state, paths, search);
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      state.influences[v] = vertex.fit(v);
    }
  });
}

std::vector<double> lossesWithout(const FitState& state, int candidateCount, int most) {
  constexpr std::size_t enough = 1500;
  const std::size_t stride = std::max<std::size_t>(1, state.vertexCount() / enough);
  const BonePaths paths(state);
  VertexFit vertex(state, paths, {candidatesOf(state, candidateCount), most, WeightSearch::everywhere});
  std::vector<double> losses(state.boneCount, 0.0);
  for (std::size_t v = 0; v < state.vertexCount(); v += stride) {
    vertex.addLosses(v, static_cast<double>(stride), losses);
  }
  return losses;
}

std::vector<double> vertexErrors(const FitState& state) {
  const BonePaths paths(state);
  std::vector<double> errors(state.vertexCount(), 0.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, errors.size(), 64), [&](const auto& range) {
    Eigen::VectorXf deviation(static_cast<Eigen::Index>(3 * state.frameCount));
    Eigen::VectorXf sum(deviation.size());
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      const Influences& influences = state.influences[v];
      const Eigen::Vector3f point = state.bind[v].cast<float>();
      sum.setZero();
      for (std::size_t i = 0; i < Influences::capacity; ++i) {
        if (influences.weights[i] != 0.0F) {
          paths.deviation(influences.bones[i], point, state.observed.col(static_cast<Eigen::Index>(v)),
                          deviation);
          sum += influences.weights[i] * deviation;
        }
      }
      errors[v] = static_cast<double>(sum.squaredNorm());
    }
  });
  return errors;
}

} // namespace stretch::skinning::fit

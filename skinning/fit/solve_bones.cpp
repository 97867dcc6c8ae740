#include "skinning/fit/solve_bones.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <tbb/parallel_for.h>

namespace stretch::skinning::fit {
namespace {

Eigen::Vector4d homogeneous(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z(), 1.0};
}

/// The rotation nearest to a matrix: U V^T of its singular value decomposition, never a mirror.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) {
    u.col(2) = -u.col(2);
  }
  return u * svd.matrixV().transpose();
}

/// One bone against what the others leave: minimise tr(M G M^T) - 2 tr(M C^T) over M = R A diag(s) A^T with a
/// translation.
void fitBone(const Eigen::Matrix4d& gram, const BoneMatrix& pull, const Eigen::Matrix3d& axes,
             StretchFit stretch, double largestScale, BoneMatrix& matrix, Eigen::Vector3d& scale) {
  const double mass = gram(3, 3);
  if (!(mass > 1e-9)) {
    return;
  }
  const Eigen::Vector3d centre = gram.block<3, 1>(0, 3) / mass;
  const Eigen::Matrix3d spread =
      axes.transpose() * (gram.block<3, 3>(0, 0) - mass * centre * centre.transpose()) * axes;
  const Eigen::Matrix3d moment = (pull.leftCols<3>() - pull.col(3) * centre.transpose()) * axes;
  const double ridge = 1e-5 * spread.trace() + 1e-300;
  Eigen::Matrix3d turned;
  for (int round = 0; round < (stretch == StretchFit::free ? 2 : 1); ++round) {
    turned = nearestRotation(moment * scale.asDiagonal());
    for (Eigen::Index a = 0; a < 3 && stretch == StretchFit::free; ++a) {
      const double wanted = (turned.col(a).dot(moment.col(a)) + ridge * scale(a)) / (spread(a, a) + ridge);
      scale(a) = std::clamp(wanted, 1.0 / largestScale, largestScale);
    }
  }
  matrix.leftCols<3>() = turned * scale.asDiagonal() * axes.transpose();
  matrix.col(3) = pull.col(3) / mass - matrix.leftCols<3>() * centre;
}

} // namespace

BindMoments::BindMoments(const FitState& state)
    : own_(state.boneCount, Eigen::Matrix4d::Zero()), neighbours_(state.boneCount) {
  const auto productOf = [this](std::size_t a, std::size_t b) -> Eigen::Matrix4d& {
    auto& list = neighbours_[a];
    const auto found =
        std::find_if(list.begin(), list.end(), [b](const Neighbour& n) { return n.bone == b; });
    return found != list.end() ? found->product
                               : list.emplace_back(Neighbour{b, Eigen::Matrix4d::Zero()}).product;
  };
  for (std::size_t v = 0; v < state.vertexCount(); ++v) {
    const Influences& influences = state.influences[v];
    const Eigen::Vector4d point = homogeneous(state.bind[v]);
    const Eigen::Matrix4d square = point * point.transpose();
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      const auto weight = static_cast<double>(influences.weights[i]);
      if (weight == 0.0) {
        continue;
      }
      own_[influences.bones[i]] += weight * weight * square;
      for (std::size_t j = 0; j < Influences::capacity; ++j) {
        if (j != i && influences.weights[j] != 0.0F) {
          productOf(influences.bones[i], influences.bones[j]) +=
              weight * static_cast<double>(influences.weights[j]) * square;
        }
      }
    }
  }
}

ObservedMoments::ObservedMoments(const FitState& state)
    : frames_(static_cast<Eigen::Index>(state.frameCount)), moments_(state.boneCount) {
  struct Member {
    std::size_t vertex = 0;
    double weight = 0.0;
  };
  std::vector<std::vector<Member>> members(state.boneCount);
  for (std::size_t v = 0; v < state.vertexCount(); ++v) {
    const Influences& influences = state.influences[v];
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      if (influences.weights[i] != 0.0F) {
        members[influences.bones[i]].push_back({v, static_cast<double>(influences.weights[i])});
      }
    }
  }
  tbb::parallel_for(std::size_t{0}, moments_.size(), [&](std::size_t b) {
    OfBone& moment = moments_[b];
    moment = OfBone::Zero(3 * frames_, 4);
    Eigen::VectorXd path(3 * frames_);
    for (const Member& member : members[b]) {
      path = state.observed.col(static_cast<Eigen::Index>(member.vertex)).cast<double>();
      const Eigen::Vector4d point = member.weight * homogeneous(state.bind[member.vertex]);
      for (Eigen::Index column = 0; column < 4; ++column) {
        moment.col(column) += point(column) * path;
      }
    }
  });
}

std::vector<BoneMatrix> ObservedMoments::at(std::size_t frame) const {
  const auto k = static_cast<Eigen::Index>(frame);
  std::vector<BoneMatrix> moments(moments_.size());
  for (std::size_t b = 0; b < moments.size(); ++b) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      moments[b].row(axis) = moments_[b].row(axis * frames_ + k);
    }
  }
  return moments;
}

namespace {

/// What one bone is pulled to, the others held.
BoneMatrix pullOf(const FitState& state, const BindMoments& bind, const std::vector<BoneMatrix>& observed,
                  std::size_t frame, std::size_t bone) {
  BoneMatrix pull = observed[bone];
  for (const BindMoments::Neighbour& neighbour : bind.neighbours(bone)) {
    pull -= state.matrix(frame, neighbour.bone) * neighbour.product;
  }
  return pull;
}

/// The stretch of the best affine map of a bone in one frame, symmetric; along directions in which its
/// vertices hardly reach it stays as it is.
Eigen::Matrix3d stretchWanted(const Eigen::Matrix4d& gram, const BoneMatrix& pull, const BoneMatrix& now) {
  const double mass = gram(3, 3);
  if (!(mass > 1e-9)) {
    return Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector3d centre = gram.block<3, 1>(0, 3) / mass;
  const Eigen::Matrix3d spread = gram.block<3, 3>(0, 0) - mass * centre * centre.transpose();
  const Eigen::Matrix3d ridge = (1e-3 * spread.trace() + 1e-300) * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d moment = pull.leftCols<3>() - pull.col(3) * centre.transpose();
  const Eigen::Matrix3d affine =
      (spread + ridge).ldlt().solve((moment + ridge * now.leftCols<3>()).transpose()).transpose();
  const Eigen::Matrix3d stretch = nearestRotation(affine).transpose() * affine;
  return 0.5 * (stretch + stretch.transpose());
}

/// The axes, right-handed, along which stretches of many frames differ most from none.
Eigen::Matrix3d axesOf(const std::vector<Eigen::Matrix3d>& stretches) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Matrix3d& stretch : stretches) {
    const Eigen::Matrix3d change = stretch - Eigen::Matrix3d::Identity();
    sum += change * change;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) {
    axes.col(0) = -axes.col(0);
  }
  return axes;
}

} // namespace

void fitBones(FitState& state, std::vector<Eigen::Vector3d>& scales, StretchFit stretch, int sweeps) {
  const BindMoments bind(state);
  const ObservedMoments moments(state);
  tbb::parallel_for(std::size_t{0}, state.frameCount, [&](std::size_t frame) {
    const std::vector<BoneMatrix> observed = moments.at(frame);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t b = 0; b < state.boneCount; ++b) {
        fitBone(bind.own(b), pullOf(state, bind, observed, frame, b), state.axes[b], stretch,
                state.largestScale, state.matrix(frame, b), scales[frame * state.boneCount + b]);
      }
    }
  });
}

void turnAxes(FitState& state, std::vector<Eigen::Vector3d>& scales) {
  const BindMoments bind(state);
  const ObservedMoments moments(state);
  std::vector<std::vector<Eigen::Matrix3d>> stretches(state.boneCount,
                                                      std::vector<Eigen::Matrix3d>(state.frameCount));
  tbb::parallel_for(std::size_t{0}, state.frameCount, [&](std::size_t frame) {
    const std::vector<BoneMatrix> observed = moments.at(frame);
    for (std::size_t b = 0; b < state.boneCount; ++b) {
      stretches[b][frame] =
          stretchWanted(bind.own(b), pullOf(state, bind, observed, frame, b), state.matrix(frame, b));
    }
  });
  for (std::size_t b = 0; b < state.boneCount; ++b) {
    const Eigen::Matrix3d axes = axesOf(stretches[b]);
    state.axes[b] = axes;
    for (std::size_t k = 0; k < state.frameCount; ++k) {
      scales[k * state.boneCount + b] = (axes.transpose() * stretches[b][k] * axes)
                                            .diagonal()
                                            .cwiseMax(1.0 / state.largestScale)
                                            .cwiseMin(state.largestScale);
    }
  }
}

double rootMeanSquare(const FitState& state) {
  const std::vector<double> errors = vertexErrors(state);
  const double total = std::accumulate(errors.begin(), errors.end(), 0.0);
  return std::sqrt(total / static_cast<double>(state.frameCount * state.vertexCount()));
}

} // namespace stretch::skinning::fit

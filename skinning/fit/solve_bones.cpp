#include "skinning/fit/solve_bones.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <tbb/parallel_for.h>

namespace stretch::skinning::fit {
namespace {

Eigen::Vector4d homogeneous(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z(), 1.0};
}

Eigen::Vector3d observedAt(const FitState& state, std::size_t vertex, std::size_t frame) {
  const auto frames = static_cast<Eigen::Index>(state.frameCount);
  const auto column = static_cast<Eigen::Index>(vertex);
  const auto row = static_cast<Eigen::Index>(frame);
  return Eigen::Vector3f(state.observed(row, column), state.observed(frames + row, column),
                         state.observed(2 * frames + row, column))
      .cast<double>();
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

void fitBones(FitState& state, std::vector<Eigen::Vector3d>& scales, StretchFit stretch, int sweeps) {
  const BindMoments bind(state);
  const ObservedMoments moments(state);
  tbb::parallel_for(std::size_t{0}, state.frameCount, [&](std::size_t frame) {
    const std::vector<BoneMatrix> observed = moments.at(frame);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t b = 0; b < state.boneCount; ++b) {
        BoneMatrix pull = observed[b];
        for (const BindMoments::Neighbour& neighbour : bind.neighbours(b)) {
          pull -= state.matrix(frame, neighbour.bone) * neighbour.product;
        }
        fitBone(bind.own(b), pull, state.axes[b], stretch, state.largestScale, state.matrix(frame, b),
                scales[frame * state.boneCount + b]);
      }
    }
  });
}

double rootMeanSquare(const FitState& state) {
  std::vector<double> sums(state.vertexCount(), 0.0);
  tbb::parallel_for(std::size_t{0}, state.vertexCount(), [&](std::size_t v) {
    const Influences& influences = state.influences[v];
    for (std::size_t frame = 0; frame < state.frameCount; ++frame) {
      Eigen::Vector3d deviation = -observedAt(state, v, frame);
      for (std::size_t i = 0; i < Influences::capacity; ++i) {
        if (influences.weights[i] != 0.0F) {
          deviation += static_cast<double>(influences.weights[i]) * state.matrix(frame, influences.bones[i]) *
                       homogeneous(state.bind[v]);
        }
      }
      sums[v] += deviation.squaredNorm();
    }
  });
  const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
  return std::sqrt(total / static_cast<double>(state.frameCount * state.vertexCount()));
}

} // namespace stretch::skinning::fit

#include "skinning/fit/solve_chain.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include "skinning/fit/solve_bones.h"

namespace stretch::skinning::fit {
namespace {

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

Eigen::Vector3d crossOf(const Eigen::Matrix3d& product) {
  // product = sum y r^T -> sum y x r.
  return {product(1, 2) - product(2, 1), product(2, 0) - product(0, 2), product(0, 1) - product(1, 0)};
}

/// One frame of the chain while it is fitted.
struct Links {
  std::vector<Eigen::Matrix3d> rotations;
  Eigen::Vector3d root;
  std::vector<BoneMatrix> matrices;
};

class FrameFit {
public:
  FrameFit(const Chain& chain, const BindMoments& bind, const std::vector<BoneMatrix>& observed,
           std::size_t frame)
      : chain_(chain), bind_(bind), observed_(observed), bones_(observed.size()), frame_(frame) {}

  void place(Links& links) const {
    Eigen::Vector3d position = links.root;
    links.matrices.resize(bones_);
    for (std::size_t b = 0; b < bones_; ++b) {
      const Eigen::Matrix3d linear = links.rotations[b] * chain_.stretches[frame_ * bones_ + b];
      links.matrices[b].leftCols<3>() = linear;
      links.matrices[b].col(3) = position - linear * chain_.pivots[b];
      position += linear * (chain_.pivots[b + 1] - chain_.pivots[b]);
    }
  }

  /// Squared error but for the constant sum of squared observations.
  [[nodiscard]] double energy(const Links& links) const {
    double squaredError = 0.0;
    for (std::size_t b = 0; b < bones_; ++b) {
      BoneMatrix pushed = links.matrices[b] * bind_.own(b);
      for (const BindMoments::Neighbour& neighbour : bind_.neighbours(b)) {
        pushed += links.matrices[neighbour.bone] * neighbour.product;
      }
      squaredError += links.matrices[b].cwiseProduct(pushed - 2.0 * observed_[b]).sum();
    }
    for (std::size_t b = 0; b < bones_; ++b) {
      squaredError +=
          0.5 * hold(b) * (links.rotations[b] - chain_.rotations[frame_ * bones_ + b]).squaredNorm();
    }
    return squaredError;
  }

  /// Gradient and Gauss-Newton matrix over (root, rotation of bone 0, 1, ...), every rotation a small turn in
  /// world axes.
  void linearise(const Links& links, Eigen::MatrixXd& matrix, Eigen::VectorXd& pull) const {
    const auto size = static_cast<Eigen::Index>(6 * bones_);
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(size, size); // Over (turn, shift) of every bone on its own.
    Eigen::VectorXd freePull(size);
    std::vector<Eigen::Matrix<double, 3, 4>> arms(bones_); // v -> where it is, seen from the bone's pivot.
    for (std::size_t b = 0; b < bones_; ++b) {
      const Eigen::Matrix3d linear = links.matrices[b].leftCols<3>();
      arms[b].leftCols<3>() = linear;
      arms[b].col(3) = -linear * chain_.pivots[b];
    }
    for (std::size_t b = 0; b < bones_; ++b) {
      BoneMatrix residual = observed_[b] - links.matrices[b] * bind_.own(b);
      addPair(free, arms, b, b, bind_.own(b));
      for (const BindMoments::Neighbour& neighbour : bind_.neighbours(b)) {
        residual -= links.matrices[neighbour.bone] * neighbour.product;
        addPair(free, arms, b, neighbour.bone, neighbour.product);
      }
      const auto row = static_cast<Eigen::Index>(6 * b);
      freePull.segment<3>(row) = crossOf(arms[b] * residual.transpose());
      freePull.segment<3>(row + 3) = residual.col(3);
      // 1/2 |R - R0|^2 = 3 - tr(R0^T R): its gradient over small turns of R is the axial part of R0 R^T.
      const Eigen::Matrix3d back = chain_.rotations[frame_ * bones_ + b] * links.rotations[b].transpose();
      freePull.segment<3>(row) +=
          hold(b) *
          Eigen::Vector3d(back(2, 1) - back(1, 2), back(0, 2) - back(2, 0), back(1, 0) - back(0, 1)) * 0.5;
      free.block<3, 3>(row, row).diagonal().array() += hold(b);
    }
    chainRows(links, free, freePull, matrix, pull);
  }

private:
  /// How strongly a bone is held to the rotation that it starts with: so many times its own resistance to
  /// being turned.
  [[nodiscard]] double hold(std::size_t bone) const {
    const Eigen::Matrix4d& own = bind_.own(bone);
    const Eigen::Vector3d& pivot = chain_.pivots[bone];
    return chain_.hold * (own.block<3, 3>(0, 0).trace() - 2.0 * pivot.dot(own.block<3, 1>(0, 3)) +
                          own(3, 3) * pivot.squaredNorm());
  }

  static void addPair(Eigen::MatrixXd& free, const std::vector<Eigen::Matrix<double, 3, 4>>& arms,
                      std::size_t a, std::size_t b, const Eigen::Matrix4d& product) {
    const Eigen::Matrix3d spread = arms[a] * product * arms[b].transpose();
    const Eigen::Vector3d armA = arms[a] * product.col(3);
    const Eigen::Vector3d armB = arms[b] * product.col(3);
    const auto row = static_cast<Eigen::Index>(6 * a);
    const auto column = static_cast<Eigen::Index>(6 * b);
    free.block<3, 3>(row, column) += spread.trace() * Eigen::Matrix3d::Identity() - spread.transpose();
    free.block<3, 3>(row, column + 3) += crossMatrix(armA);
    free.block<3, 3>(row + 3, column) -= crossMatrix(armB);
    free.block<3, 3>(row + 3, column + 3) += product(3, 3) * Eigen::Matrix3d::Identity();
  }

  /// Shifts are no freedoms of their own: that of a bone is the root's plus what the turns of the bones
  /// before it do.
  void chainRows(const Links& links, const Eigen::MatrixXd& free, const Eigen::VectorXd& freePull,
                 Eigen::MatrixXd& matrix, Eigen::VectorXd& pull) const {
    const auto bones = static_cast<Eigen::Index>(bones_);
    const Eigen::Index size = 3 + 3 * bones;
    Eigen::MatrixXd half(size, 6 * bones); // Rows reduced, columns still free.
    Eigen::MatrixXd rowsBeyond = Eigen::MatrixXd::Zero(3, 6 * bones);
    Eigen::Vector3d pullBeyond = Eigen::Vector3d::Zero();
    pull.resize(size);
    std::vector<Eigen::Matrix3d> levers(bones_);
    for (Eigen::Index b = bones - 1; b >= 0; --b) {
      const auto bone = static_cast<std::size_t>(b);
      levers[bone] =
          crossMatrix(links.matrices[bone].leftCols<3>() * (chain_.pivots[bone + 1] - chain_.pivots[bone]));
      half.middleRows<3>(3 + 3 * b) = free.middleRows<3>(6 * b) + levers[bone] * rowsBeyond;
      pull.segment<3>(3 + 3 * b) = freePull.segment<3>(6 * b) + levers[bone] * pullBeyond;
      rowsBeyond += free.middleRows<3>(6 * b + 3);
      pullBeyond += freePull.segment<3>(6 * b + 3);
    }
    half.topRows<3>() = rowsBeyond;
    pull.head<3>() = pullBeyond;
    matrix.resize(size, size);
    Eigen::MatrixXd columnsBeyond = Eigen::MatrixXd::Zero(size, 3);
    for (Eigen::Index b = bones - 1; b >= 0; --b) {
      matrix.middleCols<3>(3 + 3 * b) =
          half.middleCols<3>(6 * b) + columnsBeyond * levers[static_cast<std::size_t>(b)].transpose();
      columnsBeyond += half.middleCols<3>(6 * b + 3);
    }
    matrix.leftCols<3>() = columnsBeyond;
  }

  const Chain& chain_;
  const BindMoments& bind_;
  const std::vector<BoneMatrix>& observed_;
  std::size_t bones_;
  std::size_t frame_;
};

Links stepped(const Links& links, const Eigen::VectorXd& step) {
  Links next = links;
  next.root += step.head<3>();
  for (std::size_t b = 0; b < links.rotations.size(); ++b) {
    const Eigen::Vector3d turn = step.segment<3>(static_cast<Eigen::Index>(3 + 3 * b));
    const double angle = turn.norm();
    if (angle > 1e-12) {
      const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle, turn / angle) *
                                        Eigen::Quaterniond(links.rotations[b]));
      next.rotations[b] = rotation.normalized().toRotationMatrix();
    }
  }
  return next;
}

/// Levenberg-Marquardt: a step that does not help is tried again shorter.
void fitFrame(const FrameFit& fit, Links& links, int iterations) {
  fit.place(links);
  double energy = fit.energy(links);
  double damping = 1e-4;
  for (int i = 0; i < iterations; ++i) {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd pull;
    fit.linearise(links, matrix, pull);
    const double scale = matrix.trace() / static_cast<double>(matrix.rows());
    bool better = false;
    for (int attempt = 0; attempt < 6 && !better; ++attempt, damping *= 10.0) {
      Eigen::MatrixXd damped = matrix;
      damped.diagonal() += damping * matrix.diagonal();
      damped.diagonal().array() += 1e-9 * scale + 1e-300;
      Links next = stepped(links, damped.ldlt().solve(pull));
      fit.place(next);
      const double nextEnergy = fit.energy(next);
      if (nextEnergy < energy) {
        links = std::move(next);
        energy = nextEnergy;
        better = true;
        damping *= 0.01;
      }
    }
    if (!better) {
      return;
    }
  }
}

} // namespace

void fitChain(FitState& state, Chain& chain, int iterations) {
  const BindMoments bind(state);
  const ObservedMoments moments(state);
  tbb::parallel_for(std::size_t{0}, state.frameCount, [&](std::size_t frame) {
    const std::vector<BoneMatrix> observed = moments.at(frame);
    const FrameFit fit(chain, bind, observed, frame);
    const auto first = static_cast<std::ptrdiff_t>(frame * state.boneCount);
    const auto last = first + static_cast<std::ptrdiff_t>(state.boneCount);
    Links links{{chain.rotations.begin() + first, chain.rotations.begin() + last}, chain.roots[frame], {}};
    fitFrame(fit, links, iterations);
    std::copy(links.rotations.begin(), links.rotations.end(), chain.rotations.begin() + first);
    chain.roots[frame] = links.root;
    std::copy(links.matrices.begin(), links.matrices.end(), state.matrices.begin() + first);
  });
}

} // namespace stretch::skinning::fit

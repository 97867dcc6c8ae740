#pragma once

#include "skinning/fit/fit_state.h"

namespace stretch::skinning::fit {

/// Sums that bones need of the bind pose and the weights: for vertices v (with 1 appended) and weights w,
/// the products sum w_a w_b v v^T of every pair of bones that share a vertex. The same for every frame.
class BindMoments {
public:
  explicit BindMoments(const FitState& state);

  struct Neighbour {
    std::size_t bone = 0;
    Eigen::Matrix4d product; ///< sum w_a w_b v v^T.
  };

  [[nodiscard]] const Eigen::Matrix4d& own(std::size_t bone) const { return own_[bone]; }
  [[nodiscard]] const std::vector<Neighbour>& neighbours(std::size_t bone) const { return neighbours_[bone]; }

private:
  std::vector<Eigen::Matrix4d> own_;
  std::vector<std::vector<Neighbour>> neighbours_;
};

/// sum w_b x v^T of every bone and frame: what the observed positions x pull the bones to.
class ObservedMoments {
public:
  explicit ObservedMoments(const FitState& state);

  /// One for each bone.
  [[nodiscard]] std::vector<BoneMatrix> at(std::size_t frame) const;

private:
  using OfBone = Eigen::Matrix<double, Eigen::Dynamic, 4>; ///< Rows as Trajectories: x of all frames, then y,
                                                           ///< then z.
  Eigen::Index frames_;
  std::vector<OfBone> moments_;
};

/// Which factors a bone may scale by in the fit.
enum class StretchFit {
  fixed, ///< Those that its matrix holds stay.
  free,  ///< Fitted frame by frame along the bone's axes.
};

/// Lowers the squared error over all vertices and frames by fitting each bone in turn, the others held:
/// rotation and translation, and the scale along the bone's axes where it is free. `sweeps` rounds over all
/// bones. `scales` holds frame after frame three factors for each bone; it is read, and written where the
/// stretch is free.
void fitBones(FitState& state, std::vector<Eigen::Vector3d>& scales, StretchFit stretch, int sweeps);

/// Turns the axes of every bone to where its best affine maps stretch it over the frames, and sets the scales
/// along them; the matrices follow with the next fitBones. For bones whose direction nothing else says.
void turnAxes(FitState& state, std::vector<Eigen::Vector3d>& scales);

/// Root of the mean squared distance over all vertices and frames, in the units of the state (box diagonals).
[[nodiscard]] double rootMeanSquare(const FitState& state);

} // namespace stretch::skinning::fit

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "skinning/fit/alternate.h"
#include "skinning/fit/fit_state.h"

// Internal to skinning/fit: free bones and weights in turn.

namespace stretch::skinning::fit {

/// Error as a fraction of the diagonal: less is hardly seen, and more bones would do more than long fits.
inline constexpr double fineError = 5e-4;

/// All that a fit changes, and the root of the mean squared distance with it.
struct Reached {
  std::vector<Influences> influences;
  std::vector<BoneMatrix> matrices;
  std::vector<Eigen::Matrix3d> axes;
  std::vector<Eigen::Vector3d> scales;
  double error = 0.0;
};

/// Rounds of weights and bones: either is fitted with the other held. That alone creeps along where a bone
/// has to wander over the mesh, so a round starts from bones that are moved on the way that they went before
/// (Nesterov's steps); one that leads astray is taken back and the next starts from rest.
class FreeFit {
public:
  FreeFit(FitState state, std::vector<Eigen::Vector3d> scales, const FitSettings& settings);

  /// Until rounds lower the error by less than `leastGain` of it, at most `rounds`; ends with the best that
  /// was reached. False when it was told to stop.
  bool settle(int rounds, double leastGain, const Proceed& proceed = {});

  /// Gives `bone` to other vertices: it follows them as well as it can, and the weights of all are solved
  /// anew.
  void giveTo(std::size_t bone, const std::vector<std::size_t>& vertices);

  [[nodiscard]] const FitState& state() const { return state_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& scales() const { return scales_; }
  [[nodiscard]] const FitSettings& settings() const { return settings_; }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] Reached reached() const;
  void goBackTo(const Reached& reached);

private:
  void fitBonesOnce();
  void round(int number, bool ahead, const std::vector<BoneMatrix>& shown);

  FitState state_;
  std::vector<Eigen::Vector3d> scales_;
  FitSettings settings_;
  double error_ = 0.0;
  bool turning_ = false; ///< Axes are turned from time to time, as long as that helps.
};

/// Takes bones from where the others could nearly do their work and gives them to parts that are followed
/// worst, as long as that lowers the error (Le and Deng 2012 place such bones anew, too). False when told to
/// stop.
bool moveBones(FreeFit& fit, const Proceed& proceed);

} // namespace stretch::skinning::fit

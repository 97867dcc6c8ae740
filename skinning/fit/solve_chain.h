#pragma once

#include "skinning/fit/fit_state.h"

namespace stretch::skinning::fit {

/// Bones in a row: bone b turns and stretches about pivots[b], and pivots[b + 1] of the bind pose is carried
/// by it, so that one position for each frame and one rotation for each bone say everything once the stretch
/// is known.
struct Chain {
  std::vector<Eigen::Vector3d> pivots;    ///< One for each bone and one for the end.
  std::vector<Eigen::Matrix3d> stretches; ///< Symmetric, frame after frame, one for each bone.
  std::vector<Eigen::Matrix3d> rotations; ///< Frame after frame, one for each bone: read as the start,
                                          ///< written.
  std::vector<Eigen::Vector3d> roots;     ///< Place of pivots[0] in each frame: read as the start, written.
  double hold = 0.5; ///< How firmly bones are held to the rotations of the start, in their own resistance to
                     ///< being turned.
};

/// Lowers the squared error over all vertices frame by frame, over the rotations and the root, by
/// Gauss-Newton steps with damping; weights, bind pose and stretches are given, and rotations are held near
/// those of the start. Writes the bone matrices of the state. Never raises the error of the start.
void fitChain(FitState& state, Chain& chain, int iterations);

} // namespace stretch::skinning::fit

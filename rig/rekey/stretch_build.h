#pragma once

#include <vector>

#include "rig/rekey/rekey.h"
#include "rig/rekey/stretch_frames.h"
#include "rig/rekey/track_build.h"

namespace stretch::rig {

/// Key times of the stretch that the source has already at a node (Scene::bindChains); empty without one.
[[nodiscard]] std::vector<double> sourceStretchTimes(const ExactMotion& exact, NodeIndex node);

/// A joint that some parts stretch.
struct StretchWindows {
  NodeIndex node;
  const StretchFrames* frames = nullptr; ///< Its own.
  std::vector<KeyWindow> windows;        ///< Disjoint, ascending, at least one.
};

/// The stretch of each joint as keys: at the times of its windows, and outside them at those of the stretch
/// that the source has already.
[[nodiscard]] std::vector<StretchKeys> buildStretches(ExactMotion& exact,
                                                      const std::vector<StretchWindows>& stretched);

} // namespace stretch::rig

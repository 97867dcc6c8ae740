#pragma once

#include <vector>

#include "rig/rekey/rekey.h"
#include "rig/rekey/stretch_frames.h"
#include "rig/rekey/track_build.h"

namespace stretch::rig {

/// Key times of the stretch that the source has already at a node (Scene::bindChains); empty without one.
[[nodiscard]] std::vector<double> sourceStretchTimes(const ExactMotion& exact, NodeIndex node);

/// The stretch of one joint as keys: at the times of its windows, and outside them at those of the stretch
/// that the source has already.
[[nodiscard]] StretchKeys buildStretch(ExactMotion& exact, const StretchFrames& frames, NodeIndex node,
                                       const std::vector<KeyWindow>& windows);

} // namespace stretch::rig

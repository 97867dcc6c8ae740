#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/math/types.h"

namespace stretch::rig {

/// A LINEAR track of rotations, of as few of the keys as keep every one of them within `radians`. Times
/// ascend, one turn for each.
[[nodiscard]] Track thinTurns(NodeIndex node, const std::vector<float>& times, std::vector<Quat> turns,
                              double radians);

/// Thins keys of places, within `distance`.
[[nodiscard]] Track thinPlaces(NodeIndex node, const std::vector<float>& times,
                               const std::vector<Vec3>& places, double distance);

} // namespace stretch::rig

#pragma once

#include <optional>

#include "core/anim/clip.h"
#include "core/scene/scene.h"

namespace stretch::rig {

/// How far the body gets from a clip's first pose to its last where the last is the first again: such a clip
/// can be played as a loop. Nothing where the two poses differ by more than a hundredth of `height` in the
/// place of any node, seen from the hips (none: from the scene's origin), or where the clip has no
/// length. What does not hang on the hips may stay in its place instead. Level with the ground: a body that
/// ends higher than it began does not loop.
[[nodiscard]] std::optional<Vec3> loopTravel(const Scene& scene, const Clip& clip, NodeIndex hips,
                                             double height);

} // namespace stretch::rig

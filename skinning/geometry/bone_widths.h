#pragma once

#include <cstddef>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"

namespace stretch::skinning {

/// How thick the surface around each bone is in a pose, world units: the mean shape diameter
/// (shape_diameter.h) of the triangles that follow it, 0 for a bone that none follows. `boneOfNode`: the
/// bone, 0 to `boneCount` - 1, that what each node moves most belongs to; -1: none of them.
[[nodiscard]] std::vector<double> boneWidths(const Scene& scene, const FrameState& pose,
                                             const std::vector<int>& boneOfNode, std::size_t boneCount);

} // namespace stretch::skinning

#pragma once

#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// The start of a fit for a body without a centre line: parts that move alike, each with one bone. One part
/// is split again and again where it fits its own motion worst, and every vertex goes to the bone that
/// follows it best (clustering by splitting, as Le and Deng 2012 start theirs). Bones have no direction:
/// their axes are the mesh's. Every vertex hangs on one bone. `boneCount` of at least 1; parts too small to
/// split leave fewer bones. Frames before `firstFrame` do not count.
[[nodiscard]] SkinnedSequence clustersOfMotion(const MeshSequence& sequence, int boneCount,
                                               std::size_t firstFrame);

} // namespace stretch::skinning

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "skinning/fit/alternate.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Hangs free bones together: where two bones share vertices, their joint is the point of the bind pose that
/// both carry to nearly the same place in every frame, and the tree is the one of bones that share much and
/// whose joints come apart little (Le and Deng 2014). Sets every bone's parent, moves its pivot to the joint
/// and its end to the middle of what hangs on it; what the bones do to the mesh stays the same. Bones of a
/// body in several parts get a root for each.
void hangTogether(SkinnedSequence& skinned);

/// Moves joints that stick out of the bind mesh onto its surface, where there is room a quarter of the body's
/// thickness deeper; bones do to the mesh what they did. Nothing changes for a mesh without thickness;
/// an open one has that of what it encloses together with the middle of its vertices. The bones stay where
/// they are once `proceed` says so.
void bringJointsInside(SkinnedSequence& skinned, const Proceed& proceed);

/// Indices of the bones, parents before what hangs on them.
[[nodiscard]] std::vector<std::size_t> orderOfTree(const std::vector<SkinBone>& bones);

/// For each bone the middle of the pivots that hang on it; nothing where nothing does.
[[nodiscard]] std::vector<std::optional<Vec3>> middlesOfChildren(const std::vector<SkinBone>& bones);

} // namespace stretch::skinning

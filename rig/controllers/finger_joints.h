#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// The chains of joints below the end of an arm, each base first and without branches; a joint that branches
/// is part of the palm, and one that holds a mesh of its own on a skinned character is no finger. Where the
/// end has no joint, those below the arm's last joint, if they are several.
[[nodiscard]] std::vector<std::vector<NodeIndex>> fingerChains(const Scene& scene, const Limb& arm);

/// All joints of these chains.
[[nodiscard]] std::vector<NodeIndex> fingerJoints(const Scene& scene, const Limb& arm);

} // namespace stretch::rig

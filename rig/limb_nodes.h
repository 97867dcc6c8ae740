#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// For each node of the scene the index of the limb whose flesh follows it, or -1: its own joints, then its
/// end, then what hangs on any of these, unless it is another limb's: fingers belong to the arm, the head to
/// the neck, shoulders and hips to the trunk. Of several limbs with the same joint the first counts.
[[nodiscard]] std::vector<int> limbOfNodes(const Scene& scene, const std::vector<Limb>& limbs,
                                           NodeIndex hips);

/// Whether the node is the limb's end or hangs on it: a hand with its fingers, a foot, the head.
[[nodiscard]] bool isAtEnd(const Scene& scene, const Limb& limb, NodeIndex node);

} // namespace stretch::rig

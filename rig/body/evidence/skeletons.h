#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig::body {

/// Topmost joints of skeletons that may each be a character of its own: joints of skins that hang from no
/// other one and carry, themselves counted, at least five. Of more than eight those that carry most, in the
/// order of the file.
[[nodiscard]] std::vector<NodeIndex> skeletonsApart(const Scene& scene);

/// Joints that hang side by side below a topmost one, where the file puts several characters under one root:
/// those that carry, themselves counted, at least ten.
[[nodiscard]] std::vector<NodeIndex> skeletonsUnder(const Scene& scene, NodeIndex top);

/// Topmost joints of skeletons that stand in the place of the one that `own` are joints of: as clothes have
/// them that bring a copy of their wearer's. Half of its joints stand where some of `own`
/// do, or of as many as those are.
[[nodiscard]] std::vector<NodeIndex> copiesOf(const Scene& scene, const BindPose& bindPose,
                                              const std::vector<NodeIndex>& own);

} // namespace stretch::rig::body

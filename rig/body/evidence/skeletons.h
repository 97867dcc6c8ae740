#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/evidence/body_view.h"

namespace stretch::rig::body {

/// Topmost joints of skeletons that may each be a character of its own: joints of skins that hang from no
/// other one and carry, themselves counted, at least five. Of more than eight those that carry most, in the
/// order of the file.
[[nodiscard]] std::vector<NodeIndex> skeletonsApart(const Scene& scene);

/// Joints that hang side by side below a topmost one, where the file puts several characters under one root:
/// those that carry, themselves counted, at least ten.
[[nodiscard]] std::vector<NodeIndex> skeletonsUnder(const Scene& scene, NodeIndex top);

/// Topmost joints of skeletons that stand in the place of the one that `own` are joints of: as clothes have
/// them that bring a copy of their wearer's. Half of its joints stand where some of `own` do, or half as many
/// as those are.
[[nodiscard]] std::vector<NodeIndex> copiesOf(const Scene& scene, const BindPose& bindPose,
                                              const std::vector<NodeIndex>& own);

/// Whether joints of skins are called DEF-, as rigs of Blender call those that move the mesh and no handle.
[[nodiscard]] bool hasDeformJoints(const Scene& scene);

/// Tells for each node whether it is of the asked-for kind, before names and weights are looked at. Bones
/// that exporters leave out of a skin, since no vertex follows them, count as its joints: nodes without a
/// mesh that stand apart from the joints above and below them, and those about which several rows of joints
/// begin.
/// @param clouds vertices by node.
[[nodiscard]] std::vector<bool> possibleNodes(const Scene& scene, const BindPose& bindPose,
                                              Candidates candidates,
                                              const std::vector<std::vector<Vec3>>& clouds);

} // namespace stretch::rig::body

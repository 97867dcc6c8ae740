#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/evidence/body_view.h"

namespace stretch::rig::body {

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

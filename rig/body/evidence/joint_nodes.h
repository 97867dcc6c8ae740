#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig::body {

/// Tells for each node whether it may be a joint of a skinned body: joints of skins, and bones that exporters
/// leave out of a skin since no vertex follows them. These are nodes without a mesh that stand apart from the
/// joints above and below them, and those about which several rows of joints begin.
[[nodiscard]] std::vector<bool> jointNodes(const Scene& scene, const BindPose& bindPose);

} // namespace stretch::rig::body

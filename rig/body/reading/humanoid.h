#pragma once

#include <vector>

#include "rig/body/evidence/bind_pose.h"
#include "rig/limb.h"

namespace stretch::rig::body {

/// Limbs that the VRM humanoid table of a file names: the table is normative, so its sides and joints are
/// taken as they are.
struct HumanoidTable {
  std::vector<Limb> limbs; ///< Those that the table names completely, in the order of LimbPlace.
  NodeIndex hips;
  NodeIndex head;
};

/// Empty for a scene without a table. Entries that point at no node, or out of order in the tree, are left
/// out.
[[nodiscard]] HumanoidTable readHumanoid(const Scene& scene, const BindPose& bindPose);

} // namespace stretch::rig::body

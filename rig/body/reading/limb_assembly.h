#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/facing.h"
#include "rig/limb.h"

namespace stretch::rig::body {

/// End of a limb: a joint, or a point in the world (bind pose).
struct LimbEnd {
  NodeIndex node;
  Vec3 position{0.0};
};

/// A limb of the given nodes: fills id (without the row), end offset and rest length from the bind pose.
[[nodiscard]] Limb makeLimb(const LimbPlace& place, std::vector<NodeIndex> joints, const LimbEnd& end,
                            const std::vector<Mat4>& bindWorlds);

/// Whether a limb has a length and its numbers are finite; a file with degenerate transforms makes limbs that
/// have not.
[[nodiscard]] bool isSound(const Limb& limb);

/// The four limbs of a body reading that were found, sides decided, with confidence and reasons.
[[nodiscard]] std::vector<Limb> limbsOfReading(const Scene& scene, const BodyView& view,
                                               const BipedReading& reading, const Sides& sides,
                                               const BindPose& bindPose);

/// Spine and neck of a trunk. A spine of one joint ends at the neck or head, else between the shoulders;
/// without a joint above the hips it starts at the hips. Without a joint between spine and head there is no
/// neck.
[[nodiscard]] std::vector<Limb> limbsOfTrunk(const Scene& scene, const BodyView& view,
                                             const BipedReading& reading, const Trunk& trunk,
                                             const BindPose& bindPose);

/// "a, b, c" of the nodes' names, "#index" for a node without one.
[[nodiscard]] std::string nodeNames(const Scene& scene, const std::vector<NodeIndex>& nodes);

} // namespace stretch::rig::body

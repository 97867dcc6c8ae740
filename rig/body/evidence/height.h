#pragma once

#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig::body {

/// Height of a character in its bind pose, world units, > 0: the extent of its vertices along +Y (skinned
/// meshes where there are any, else rigid ones at or below `root`; -1: all), of its joints where it has no
/// vertices. A body that does not stand (`bodyUp` more than 35 degrees from the Y axis; zero: unknown) has
/// its largest extent instead. 1 where nothing has an extent.
[[nodiscard]] double characterHeight(const Scene& scene, const BindPose& bindPose, NodeIndex root,
                                     const Vec3& bodyUp);

} // namespace stretch::rig::body

#pragma once

#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig::body {

/// Height of a character in its bind pose, world units, > 0: the extent of its vertices along +Y, of its
/// joints where it has no vertices. Skinned meshes count where there are any, and rigid ones at or below
/// `hips` with them where they make the body more than twice as high (gloves alone are skinned); else the
/// rigid ones of the hips' whole tree (-1: all). A body that does not stand (`bodyUp` more than 35 degrees
/// from the Y axis; zero: unknown) has its largest extent instead. 1 where nothing has an extent.
[[nodiscard]] double characterHeight(const Scene& scene, const BindPose& bindPose, NodeIndex hips,
                                     const Vec3& bodyUp);

} // namespace stretch::rig::body

#pragma once

#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig::body {

/// How far the vertices of a character in its bind pose reach, those of its joints where it has no vertices;
/// world units, > 0; 1 where nothing has an extent.
struct CharacterExtent {
  double height = 1.0;  ///< Along +Y.
  double largest = 1.0; ///< Along whichever axis it is largest.
};

/// Skinned meshes count where there are any, and rigid ones at or below `hips` with them where they make the
/// body more than twice as high (gloves alone are skinned); else the rigid ones of the hips' whole tree (-1:
/// all). The height of a body that does not stand (`bodyUp` more than 35 degrees from the Y axis; zero:
/// unknown) is its largest extent.
[[nodiscard]] CharacterExtent characterExtent(const Scene& scene, const BindPose& bindPose, NodeIndex hips,
                                              const Vec3& bodyUp);

} // namespace stretch::rig::body

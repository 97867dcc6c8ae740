#pragma once

#include <vector>

#include "core/math/bounds.h"
#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"

namespace stretch::rig {

/// Places of nodes and meshes in the bind pose, in the world. Vectors are indexed by node.
struct BindPlaces {
  std::vector<Mat4> worlds;
  /// Bounds of the mesh that follows each node most: the vertices whose strongest joint it is, or the rigid
  /// mesh that hangs on it. Empty where nothing does.
  std::vector<Bounds> meshes;
};

[[nodiscard]] BindPlaces bindPlaces(const Scene& scene);
/// Places of a bind pose that stands elsewhere.
[[nodiscard]] BindPlaces bindPlaces(const Scene& scene, const body::BindPose& bindPose);

} // namespace stretch::rig

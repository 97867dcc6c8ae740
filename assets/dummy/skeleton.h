#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math/types.h"

namespace stretch::assets {

struct Joint {
  std::string name;
  int parent = -1; ///< Index of the joint above; always smaller than the joint's own index. -1 for the hips.
  Vec3 position;   ///< In the bind pose, metres, model space: +Y up, the character faces +Z, its left is +X.
};

/// The dummy's joints, parents first, named as HumanIK and Mixamo name them. Every joint's axes are the
/// model's axes in the bind pose, so rotations of zero are the bind pose.
[[nodiscard]] std::vector<Joint> dummySkeleton();

/// Index of the joint of that name; a broken invariant when there is none.
[[nodiscard]] int jointIndex(const std::vector<Joint>& skeleton, std::string_view name);

[[nodiscard]] Vec3 jointPosition(const std::vector<Joint>& skeleton, std::string_view name);

/// The same place on the other side of the body.
[[nodiscard]] inline Vec3 mirrored(const Vec3& point) {
  return {-point.x, point.y, point.z};
}

} // namespace stretch::assets

#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// How a body stands in its scene.
struct Upright {
  /// Columns: across the body, upwards, forward; right-handed, of unit length. Which of the two ways across
  /// is the body's left is told by `facingKnown`.
  Mat3 axes{1.0};
  Vec3 origin{0.0}; ///< On the mirror plane, on the ground, in the middle of the depth.
  double height = 1.0;
  double symmetry = 0.0; ///< 0..1: how much of the body has its mirror image.
  double legs = 0.0;     ///< 0..1: in how much of its lowest part it stands on two legs with a gap between.

  /// Into the body's own space: the height is 1, +X across, +Y up, +Z forward, the ground at 0.
  [[nodiscard]] Vec3 toBody(const Vec3& point) const {
    return glm::transpose(axes) * (point - origin) / height;
  }
  [[nodiscard]] Vec3 toScene(const Vec3& point) const { return origin + axes * point * height; }
};

enum class UpAxis { ofScene, anyOfScene };

/// Finds which way is up, +Y where that is asked for or nothing speaks against it, and the plane that mirrors
/// the body: any direction across. Facing +Z of the scene, or the way nearest to it, until more is known.
/// Error: what voxelBody refuses.
[[nodiscard]] Result<Upright> findUpright(std::span<const Vec3> positions,
                                          const std::vector<Triangle>& triangles,
                                          UpAxis up = UpAxis::anyOfScene);

} // namespace stretch::skinning
